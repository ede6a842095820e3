// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Frames of a tool along a path, for robots.
 */
#pragma once

#include <pcl_spiral/machine/tool_moves.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** What z of a robot frame is, and where the frame is. */
enum class RobotZ {
  Axis,  ///< the tool axis, from the tip to the shank; the frame is at the tip
  Normal ///< the normal of the surface, out of the material; the frame is at the contact
};

/** The frame at the end of each of \p moves; columns x, y, z, a rotation.
 *  \verbatim
       z   y
       |  /
       | /
       |/_____ x   travel of the tip, square to z
    \endverbatim
 *  x is along the travel of the tip to its next place, at the end of the path from the one before: the contact may jump back where
 *  the tool runs on, as in a valley. Where the tip stands still (within the rounding of a ToolpathPoint) or moves along z, x stays. From
 *  one frame to the next, x turns with z by the shortest way, and about z by at most the largest turn of the travel on this
 *  path. On leads x is that of the end of the path. */
std::vector<Eigen::Matrix3d> toolFrames(const ToolMoves& moves, RobotZ z = RobotZ::Axis);

/** The largest turn of x between neighbouring frames. */
struct FrameTurn {
  double angle = 0.0;                              ///< radians
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< tip at the second of them, mm
};

/** Over all \p passes. */
FrameTurn largestFrameTurn(const std::vector<ToolMoves>& passes, RobotZ z = RobotZ::Axis);

} // namespace pcl_spiral
