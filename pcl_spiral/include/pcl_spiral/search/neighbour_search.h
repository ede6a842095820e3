/** \file
 *  The k nearest neighbours of whole blocks of points at a time.
 */
#pragma once

#include <pcl_spiral/search/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The neighbours of one query, nearest first, as offsets from the query. A point is its own first neighbour. Offsets are
 *  filled up with zeros to a multiple of \p lanes: sums over them need no tail. */
struct Neighbourhood {
  static constexpr int lanes = 8;
  int size = 0;
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* squared_distance = nullptr;
  const std::uint32_t* index = nullptr; ///< in the spatial order of the blocks
};

/** Exact k-nearest-neighbour search in PointBlocks, for queries that lie close together.
 *
 *  What could be a neighbour of any query of a run is gathered once, as a structure of arrays relative to the run's
 *  centre; then each query scans that list. One object a thread: it holds the working memory, and learns the radius.
 */
class NeighbourSearch {
public:
  /** \p k neighbours (all points, if there are fewer), none farther than \p max_radius. */
  NeighbourSearch(const PointBlocks& blocks, int k, float max_radius = 1e18f);

  /** Start on queries that lie in \p box. */
  void setRun(const Box& box);

  /** Neighbours of a query in the run's box; valid until the next call. Fewer than k only beyond max_radius. */
  const Neighbourhood& find(const Eigen::Vector3d& query);

private:
  void gather(float radius);
  void reserveCandidates(std::size_t count);
  /** Squared distances of all candidates. */
  void measure(const Eigen::Vector3f& query);
  /** Keys of the candidates within sqrt(threshold); returns how many. */
  int collectWithin(float threshold);
  int select(float squared_radius);
  void sortSelected(int count, float threshold);

  const PointBlocks& blocks_;
  int k_;
  float max_radius_;
  Box box_;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
  float gathered_radius_ = 0.0f;
  float usual_radius_ = 0.0f; ///< k-th distance seen last
  float threshold_ = 0.0f;    ///< squared distance within which the next query's neighbours are expected

  std::vector<float> candidate_x_, candidate_y_, candidate_z_, candidate_distance_;
  std::vector<std::uint32_t> candidate_index_;
  std::size_t candidates_ = 0;

  std::vector<std::uint64_t> keys_, sorted_; ///< squared distance's bits, then the candidate
  std::vector<std::uint8_t> near_, bucket_;
  std::vector<float> x_, y_, z_, squared_distance_;
  std::vector<std::uint32_t> index_;
  Neighbourhood result_;
};

} // namespace pcl_spiral
