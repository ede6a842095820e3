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

/** The deepest point of \p blocks that is deeper than \p tolerance, with the tip at height \p tip along
 *  the axis of \p frame. The search is exact. cloud_index is that of the original points of the blocks. Only points above \p above along
 *  the axis count. */
HolderCollision findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance,
                              double above = -std::numeric_limits<double>::infinity());

} // namespace pcl_spiral
