// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What could be a neighbour of any of several queries.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points about a run of queries that lie close together, gathered once as a structure of arrays relative to the run's
 *  centre, so that each query scans them in whole lanes. It learns how far it has to look. One object a thread: what it
 *  has learnt changes the time taken, not what is found.
 *
 *  A query that has to look much farther than the others, a point off the surface, gathers for itself alone. So do all in
 *  a box stretched so far that single precision would not do for offsets from its centre. */
class CandidateRun {
public:
  CandidateRun(const CandidateRun&) = delete;
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
  float offsetX(std::uint32_t candidate) const { return looked_at_->x[candidate] - query_.x(); }
  float offsetY(std::uint32_t candidate) const { return looked_at_->y[candidate] - query_.y(); }
  float offsetZ(std::uint32_t candidate) const { return looked_at_->z[candidate] - query_.z(); }
  std::uint32_t point(std::uint32_t candidate) const { return looked_at_->point[candidate]; }
  /** Room enough for whatever find picks, filled up to whole lanes. */
  std::size_t room() const { return picked_.size(); }
  int k() const { return k_; }

  /** Tell it the squared distance of the farthest neighbour of the last query. */
  void learn(float squared_distance);

private:
  /** What lies within a radius of a box, relative to the run's origin. */
  struct Candidates {
    Box box;
    float radius = 0.0f;
    std::size_t count = 0;
    std::vector<float> x, y, z;
    std::vector<std::uint32_t> point;

    void reserve(std::size_t candidates);
  };
  void gather(Candidates& into, const Box& box, float radius);
  int pick(const Candidates& from);
  int findAlone(const Eigen::Vector3d& query);
  float firstRadius(const Box& box) const;

  const PointBlocks& blocks_;
  int k_;
  float max_radius_;
  bool stretched_ = false; ///< the run's box
  int loners_ = 0;         ///< queries of the run that looked much farther than it
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero(), query_ = Eigen::Vector3f::Zero();
  float largest_radius_ = 0.0f; ///< distance of a farthest neighbour in this run, but for queries that look alone
  float usual_radius_ = 0.0f;   ///< the same in the last run that had any
  float threshold_ = 0.0f;      ///< squared distance within which the next query's neighbours are expected

  Candidates run_, alone_;
  const Candidates* looked_at_ = &run_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> picked_;
};

} // namespace pcl_spiral
