// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the passes of a finished toolpath begin.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** True if the tool is lifted on a move of \p distance mm over which the arc length grows by \p grown mm: lifts add no arc length. */
inline bool
isLift(double distance, double grown)
{
  constexpr double least = 0.01;  // mm: shorter moves are not lifts
  constexpr double share = 0.001; // of the move: files round arc lengths
  return distance > least && grown < share * distance;
}

/** Points of \p path at which the second and each later pass begins: the arc length does not grow on the move there, in any file
 *  format. Empty for one pass, and for a path without arc lengths. */
inline std::vector<std::size_t>
passBegins(const pcl::PointCloud<ToolpathPoint>& path)
{
  std::vector<std::size_t> begins;
  if (path.empty() || !(path.back().arc_length > path.front().arc_length))
    return begins;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (isLift((path[i].getVector3fMap() - path[i - 1].getVector3fMap()).norm(), path[i].arc_length - path[i - 1].arc_length))
      begins.push_back(i);
  return begins;
}

} // namespace pcl_spiral
