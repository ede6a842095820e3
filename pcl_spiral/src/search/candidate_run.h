// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points that may be neighbours of any of several queries.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points around a run of queries that lie close together. They are gathered once, as a structure of arrays relative to the centre
 *  of the run, so that each query scans them in whole lanes. The run learns how far it has to look. One object per thread: what it
 *  has learnt changes the time taken, not the result.
 *
 *  A query that has to look much farther than the others, such as a point off the surface, gathers only for itself. So do all
 *  queries in a box stretched so far that single precision is not enough for offsets from its centre. */
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
  /** For each candidate: squared distance from the query, offset from it, the point in the spatial order of the blocks. */
  const float* squaredDistances() const { return distance_.data(); }
  float offsetX(std::uint32_t candidate) const { return looked_at_->x[candidate] - query_.x(); }
  float offsetY(std::uint32_t candidate) const { return looked_at_->y[candidate] - query_.y(); }
  float offsetZ(std::uint32_t candidate) const { return looked_at_->z[candidate] - query_.z(); }
  std::uint32_t point(std::uint32_t candidate) const { return looked_at_->point[candidate]; }
  /** Room for everything that find may pick, filled up to whole lanes. */
  std::size_t room() const { return picked_.size(); }
  int k() const { return k_; }

  /** Pass the squared distance of the farthest neighbour of the last query. */
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
  bool stretched_ = false; ///< whether the box of the run is
  int wide_queries_ = 0;   ///< queries of the run that looked much farther than the run
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero(), query_ = Eigen::Vector3f::Zero();
  float largest_radius_ = 0.0f; ///< distance of the farthest neighbour in this run, except for queries that look alone
  float usual_radius_ = 0.0f;   ///< the same in the last run that had any
  float threshold_ = 0.0f;      ///< squared distance within which the next query's neighbours are expected

  Candidates run_, alone_;
  const Candidates* looked_at_ = &run_;
  std::vector<float> distance_;
  std::vector<std::uint32_t> picked_;
};

} // namespace pcl_spiral
