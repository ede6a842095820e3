/** \file
 *  Rotary angles along a path: one branch, unwound, safe at the pole.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A tool pose with the angles that reach it. */
struct MachineLocation {
  ToolPose pose;
  RotaryAngles angles;     ///< unwound: the first may come to thousands of turns
  double arc_length = 0.0; ///< of the contacts up to here, mm
};

using MachineLocations = std::vector<MachineLocation>;

/** A run of locations near the pole whose axes were blended for the first rotary axis to keep its rate. */
struct PoleZone {
  std::size_t first_pose = 0; ///< of the path that came in
  std::size_t last_pose = 0;
  double begin = 0.0; ///< arc length, mm
  double end = 0.0;
  double largest_change = 0.0; ///< of an axis, radians
};

/** How a path is laid on the rotary axes. */
struct RotaryPathSettings {
  double feed = 1000.0; ///< at the contact, mm/min
  double pivot = 0.0; ///< distance from the tip of the point on the axis that stays where it is as an axis is
                      ///< blended: a ball's radius, mm
  double pole_cone = 0.09; ///< axes are blended within this angle of the pole alone, radians
};

/** Angles of a whole path. */
struct RotaryPath {
  Branch branch = Branch::Larger;
  MachineLocations locations; ///< one a pose; axes and tips as blended
  std::vector<PoleZone> poles;
};

/** Angles for every pose of \p poses.
 *  - One branch for the whole path: Larger, or the other where it keeps more poses within the limits of the
 * second axis.
 *  - The first angle goes on from pose to pose the shorter way and is never folded; it starts nearest to
 * home.
 *  - The rate of the first axis grows without bound at the pole, as feed / distance. On moves where it would
 * be beyond its limit within the pole cone, the angle is led evenly from the one end of the run to the other,
 * or held where the run lies at an end of the path; the point at pivot on the axis stays where it was.
 *  \return InvalidInput naming the pose that is not finite or that no angles reach */
Status rotaryPath(const Kinematics& kinematics, const ToolPoses& poses, const RotaryPathSettings& settings,
                  RotaryPath& path);

} // namespace pcl_spiral
