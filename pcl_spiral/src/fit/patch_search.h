// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cloud points that one local fit uses. Private.
 */
#pragma once

#include "search/candidate_run.h"

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

/** Exact k nearest points of queries that lie close together, for fits that need no order of them: selecting takes
 *  half of the time of NeighbourSearch, which sorts. One object per thread. */
class PatchSearch {
public:
  /** \p k points (all, if there are fewer), none farther than \p max_radius. */
  PatchSearch(const PointBlocks& blocks, int k, float max_radius);

  /** Start on queries that lie in \p box. */
  void setRun(const Box& box) { run_.setRun(box); }

  /** Points about a query in the run's box; valid until the next call. Fewer than k only beyond max_radius. */
  const Patch& find(const Eigen::Vector3d& query);

private:
  CandidateRun run_;
  std::vector<float> distance_, x_, y_, z_;
  std::vector<std::uint32_t> inner_;
  Patch result_;
};

} // namespace pcl_spiral
