// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Blocks where the machine needs them: more where it bends the path, fewer where it does not.
 */
#pragma once

#include <pcl_spiral/machine/impl/rotary_path.h>

namespace pcl_spiral {

/** What the machine does at share \p t of a block: programmed axes move linearly.
 *  With RTCP these are the axes of the tip, without RTCP those of the machine. */
ToolPose interpolated(const Kinematics& kinematics, const MachineLocation& a, const MachineLocation& b, double t);

/** Adds locations until the machine stays within \p tolerance of the straight move and the
 *  arc of the axis, and no rotary axis turns by more than a quarter turn in a block. */
MachineLocations splitBlocks(const Kinematics& kinematics, Branch branch, const MachineLocations& path, const BlockTolerance& tolerance);

/** Leaves out locations if the machine, without them, comes within \p tolerance of each:
 *  tip and axis together, at the same share of the way. With RTCP the tolerance holds along
 *  the whole path, also between its locations. Without RTCP it holds plus the tolerance of
 *  splitBlocks. Ends stay. A tolerance of 0 keeps all locations except repeated ones. */
MachineLocations thinnedBlocks(const Kinematics& kinematics, const MachineLocations& path, const BlockTolerance& tolerance);

} // namespace pcl_spiral
