// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rotary angles along a path: one branch, unwound, safe at the pole.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/machine/machine_program.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A tool pose and the angles that reach it. */
struct MachineLocation {
  ToolPose pose;
  RotaryAngles angles;     ///< unwound: the first may reach thousands of turns
  double arc_length = 0.0; ///< of the contacts up to here, mm
};

using MachineLocations = std::vector<MachineLocation>;

/** Settings of rotary angles along a path. */
struct RotaryPathSettings {
  double feed = 1000.0;    ///< at the contact, mm/min
  double pivot = 0.0;      ///< distance from the tip to the point on the axis that stays in
                           ///< place while an axis is blended: the radius of a ball, mm
  double pole_cone = 0.09; ///< axes are blended only within this angle of the pole, radians
};

/** Angles of a whole path. */
struct RotaryPath {
  Branch branch = Branch::Larger;
  MachineLocations locations; ///< one per pose; axes and tips as blended
  std::vector<PoleZone> poles;
};

/** Finds the angles for every pose of \p poses.
 *  - One branch for the whole path: Larger; or the other, if it keeps more poses
 *  within the limits of the second axis.
 *  - The first angle continues from pose to pose by the shorter way and is never folded; it starts nearest to home.
 *  - The rate of the first axis grows without bound at the pole, as feed / distance.
 *  On moves within the pole cone where it would be beyond its limit, the angle
 *  changes evenly from one end of the run to the other. If the run is at an end
 *  of the path, the angle is held. The point at pivot on the axis stays in place.
 *  \return InvalidInput with the pose that is not finite or that no angles reach */
Status rotaryPath(const Kinematics& kinematics, const ToolPoses& poses, const RotaryPathSettings& settings, RotaryPath& path);

} // namespace pcl_spiral
