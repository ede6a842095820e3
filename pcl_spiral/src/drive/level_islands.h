// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Peaks of a function between two of its level lines. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Parts of a triangulation above one level that do not reach the next level. */
struct LevelIslands {
  static constexpr std::uint32_t none = Triangulation::none;
  struct Island {
    std::size_t level; ///< the level below the island
    double peak;
  };
  std::vector<Island> islands;
  std::vector<std::uint32_t> of_point; ///< entry of islands, or none
};

/** Islands of a function with \p values at the points, over ascending \p levels; points without a finite
 * value belong to none. Points with the value of a level count as above it. */
LevelIslands levelIslands(const Triangulation& mesh, const std::vector<double>& values, const std::vector<double>& levels);

} // namespace pcl_spiral
