/** \file
 *  Blocks where the machine needs them: more where it bends the path, fewer where it does not.
 */
#pragma once

#include <pcl_spiral/machine/impl/rotary_path.h>

namespace pcl_spiral {

/** How far a block may lead the tool off the path. */
struct BlockTolerance {
  static constexpr double least_tip = 1e-4, least_axis = 1e-6; ///< below, blocks would have no end
  double tip = 0.002;  ///< mm
  double axis = 0.001; ///< radians
};

/** What the machine does at share \p t of a block: programmed axes go linearly; with RTCP these are the
 * tip's, without it the machine's own. */
ToolPose interpolated(const Kinematics& kinematics, const MachineLocation& a, const MachineLocation& b,
                      double t);

/** Locations put in between until the machine stays within \p tolerance of the straight move and the arc of
 * the axis, and no rotary axis turns by more than a quarter turn in a block. */
MachineLocations splitBlocks(const Kinematics& kinematics, Branch branch, const MachineLocations& path,
                             const BlockTolerance& tolerance);

/** Locations left out where the machine comes within \p tolerance of each without them: tip and axis
 * together, at the same share of the way. With RTCP the tolerance holds all along the path, between its
 * locations too; without, with that of splitBlocks on top. Ends stay. A tolerance of 0 keeps all but repeated
 * locations. */
MachineLocations thinnedBlocks(const Kinematics& kinematics, const MachineLocations& path,
                               const BlockTolerance& tolerance);

} // namespace pcl_spiral
