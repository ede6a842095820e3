/** \file
 *  The cloud points that one local fit uses. Private to surface.
 */
#pragma once

#include <pcl_spiral/search/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The k nearest points of a query, in no order, as offsets from it; zeros fill up the last eight. */
struct Patch {
  int size = 0;
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  float squared_radius = 0.0f;          ///< of the farthest
  int inner_size = 0;                   ///< about the twelve nearest, at least one
  const std::uint32_t* inner = nullptr; ///< their indices in the spatial order of the blocks
  std::uint32_t nearest = 0;
  float nearest_squared_distance = 0.0f;
};

/** Exact k nearest points of queries that lie close together, for fits that need no order among them: selecting takes
 *  half of the time of NeighbourSearch, which sorts. One object a thread. */
class PatchSearch {
public:
  /** \p k points (all, if there are fewer), none farther than \p max_radius. */
  PatchSearch(const PointBlocks& blocks, int k, float max_radius);

  /** Start on queries that lie in \p box. */
  void setRun(const Box& box);

  /** Points about a query in the run's box; valid until the next call. Fewer than k only beyond max_radius. */
  const Patch& find(const Eigen::Vector3d& query);

private:
  void gather(float radius);
  /** Candidates within the threshold of the query: at least k, or all. Returns how many. */
  int pick(const Eigen::Vector3f& query);
  /** The k nearest of those picked. */
  void collect(int count, const Eigen::Vector3f& query);

  const PointBlocks& blocks_;
  int k_;
  float max_radius_;
  Box box_;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
  float gathered_radius_ = 0.0f;
  float usual_radius_ = 0.0f; ///< largest k-th distance of the run
  float threshold_ = 0.0f;    ///< squared distance within which the next query's points are expected

  std::vector<float> candidate_x_, candidate_y_, candidate_z_, candidate_distance_;
  std::vector<std::uint32_t> candidate_index_;
  int candidates_ = 0;

  std::vector<std::uint32_t> near_; ///< candidates picked
  std::vector<float> near_distance_, x_, y_, z_;
  std::vector<std::uint32_t> inner_;
  Patch result_;
};

} // namespace pcl_spiral
