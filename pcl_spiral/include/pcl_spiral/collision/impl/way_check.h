// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the way of ball and shank is free.
 */
#pragma once

#include <pcl_spiral/collision/surroundings.h>
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** The tool of a path. Lengths in mm. */
struct WayTool {
  double radius = 0.0;  ///< of the ball
  double allowed = 0.0; ///< how deep points may be in it; see gougeTolerance
  double spacing = 0.0; ///< of the points of the part
  bool tilted = false;  ///< it has a tilt
  bool led = false;     ///< it has a lead
};

/** \p hole_size, the least width of a hole, mm, or less, so that holes which \p keep_outs leave in the part for a ball of \p radius do not
 *  count as gaps in the data. */
double holeSizeBeside(double hole_size, const std::vector<Prism>& keep_outs, double radius);

/** Ok, or Failed with the deepest place and the remedy if ball or shank of \p tool cut into what is \p around on the moves of \p path;
 *  \p blocked says by what. Warns of single points there, which are taken for false echoes. Lifts are not looked at. */
Status checkWay(const pcl::PointCloud<ToolpathPoint>& path, const WayTool& tool, const Surroundings& around,
                std::optional<BlockedWay>& blocked, Diagnostics& warnings);

} // namespace pcl_spiral
