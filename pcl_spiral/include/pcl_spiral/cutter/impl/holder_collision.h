// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Collision of shank and holder with the points of a scan.
 */
#pragma once

#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/cutter_drop.h>

namespace pcl_spiral {

/** The point that is deepest in the shank or holder. Lengths in mm. */
struct HolderCollision {
  int segment = -1;   ///< number of the part, from the cutter upwards; -1: none
  double depth = 0.0; ///< shortest way out of it, clearance included
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::uint32_t cloud_index = 0;

  bool found() const { return segment >= 0; }
};

/** The deepest point of \p blocks that is deeper than \p tolerance, with the tip at height \p tip along
 *  the axis of \p frame. The search is exact. cloud_index is that of the original points of the blocks. */
HolderCollision findCollision(const PointBlocks& blocks, const HolderProfile& holder, const AxisFrame& frame, double tip, double tolerance);

} // namespace pcl_spiral
