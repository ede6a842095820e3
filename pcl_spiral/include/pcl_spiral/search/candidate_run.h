/** \file
 *  What could be a neighbour of any of several queries.
 */
#pragma once

#include <pcl_spiral/search/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points about a run of queries that lie close together, gathered once as a structure of arrays relative to the run's
 *  centre, so that each query scans them in whole lanes. It learns how far it has to look. One object a thread: what it
 *  has learnt changes the time taken, not what is found. */
class CandidateRun {
public:
  /** For the \p k nearest points (all, if there are fewer), none farther than \p max_radius. */
  CandidateRun(const PointBlocks& blocks, int k, float max_radius);

  /** Start on queries that lie in \p box. */
  void setRun(const Box& box);

  /** Picks candidates about a query in the run's box, among them its k nearest; fewer than k only beyond max_radius.
   *  Returns how many. */
  int find(const Eigen::Vector3d& query);

  /** What find picked: candidates in ascending order of their points. */
  const std::uint32_t* picked() const { return picked_.data(); }
  /** By candidate: squared distance from the query, offset from it, the point in the spatial order of the blocks. */
  const float* squaredDistances() const { return distance_.data(); }
  float offsetX(std::uint32_t candidate) const { return x_[candidate] - query_.x(); }
  float offsetY(std::uint32_t candidate) const { return y_[candidate] - query_.y(); }
  float offsetZ(std::uint32_t candidate) const { return z_[candidate] - query_.z(); }
  std::uint32_t point(std::uint32_t candidate) const { return point_[candidate]; }
  /** Room enough for whatever find picks, filled up to whole lanes. */
  std::size_t room() const { return picked_.size(); }
  int k() const { return k_; }

  /** Tell it the squared distance of the farthest neighbour of the last query. */
  void learn(float squared_distance);

private:
  void gather(float radius);
  void reserve(std::size_t candidates);
  int pick();

  const PointBlocks& blocks_;
  int k_;
  float max_radius_;
  Box box_;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero(), query_ = Eigen::Vector3f::Zero();
  float gathered_radius_ = 0.0f;
  float usual_radius_ = 0.0f; ///< largest distance of a farthest neighbour in this run
  float threshold_ = 0.0f;    ///< squared distance within which the next query's neighbours are expected

  std::vector<float> x_, y_, z_, distance_;
  std::vector<std::uint32_t> point_, picked_;
  std::size_t candidates_ = 0;
};

} // namespace pcl_spiral
