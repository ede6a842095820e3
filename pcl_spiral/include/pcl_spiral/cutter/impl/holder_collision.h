// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Collision of shank and holder with the points of a scan.
 */
#pragma once

#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <limits>

namespace pcl_spiral {

/** How far a tool may be from a place where it is looked at. */
struct ToolSway {
  double tip = 0.0;  ///< mm
  double turn = 0.0; ///< of the axis, radians

  /** Bound of how far a place at \p distance from the tip is displaced in the frame of the tool, mm. */
  double at(double distance) const { return tip + turn * distance; }
};

/** Distance of the farthest corner of \p box from \p place. */
double farthestCorner(const Box& box, const Eigen::Vector3d& place);

/** The deepest point of \p blocks that is deeper than \p tolerance, with the tip at height \p tip along
 *  the axis of \p frame. The search is exact. cloud_index is that of the original points of the blocks. Only points above \p above along
 *  the axis count. */
HolderCollision findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance,
                              double above = -std::numeric_limits<double>::infinity());

/** Whether a point of \p blocks may be deeper than \p tolerance in the holder, with the tip at the origin of \p frame or at any place
 *  within \p sway of it. False only if none is. */
bool mayCollide(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, const ToolSway& sway, double tolerance);

} // namespace pcl_spiral
