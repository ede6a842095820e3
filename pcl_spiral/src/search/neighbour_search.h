// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The k nearest neighbours of whole blocks of points at a time.
 */
#pragma once

#include "candidate_run.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The neighbours of one query, nearest first, as offsets from the query. A point is its own first neighbour. Offsets are
 *  filled up with zeros to whole lanes (core/lanes.h): sums over them need no tail. */
struct Neighbourhood {
  int size = 0;
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* squared_distance = nullptr;
  const std::uint32_t* index = nullptr; ///< in the spatial order of the blocks
};

/** Exact k-nearest-neighbour search in PointBlocks, for queries that lie close together; see CandidateRun. One object
 *  per thread: it holds the working memory. */
class NeighbourSearch {
public:
  /** \p k neighbours (all points, if there are fewer), none farther than \p max_radius. */
  NeighbourSearch(const PointBlocks& blocks, int k, float max_radius = 1e18f);

  /** Start on queries that lie in \p box. */
  void setRun(const Box& box) { run_.setRun(box); }

  /** Neighbours of a query in the run's box; valid until the next call. Fewer than k only beyond max_radius. */
  const Neighbourhood& find(const Eigen::Vector3d& query);

private:
  /** Candidates picked, nearest first, into sorted_. */
  void sortPicked(int count);
  void sortByBuckets(int count);

  CandidateRun run_;
  std::vector<std::int32_t> sorted_, rank_;
  std::vector<float> near_;
  std::vector<std::uint64_t> key_, sorted_key_; ///< squared distance's bits, then the candidate
  std::vector<std::uint8_t> bucket_;
  std::vector<float> x_, y_, z_, squared_distance_;
  std::vector<std::uint32_t> index_;
  Neighbourhood result_;
};

} // namespace pcl_spiral
