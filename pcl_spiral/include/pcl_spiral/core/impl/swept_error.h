// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How deep a cutter can cut on the move between two places where it does not cut.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** Bound of the depth, mm, along the normal, of any point that is outside the cutter at both ends of a straight
 *  move and inside it on the way. The axis is constant. \p height and \p distance are those between the ends, along
 *  the axis and across it. With d^2 = height^2 + distance^2 the bound is the least of
 *  - r - sqrt(r^2 - d^2 / 4), the corner's fillet against its common tangent: every part of the cutter is swept
 *    by a ball of radius r inside it. Infinite for d > 2 r. Source: Sun, Cui, Kang, Wang, five-axis NC toolpath
 *    generation from scattered points;
 *  - height distance / d, the step of a sharp edge, or R2 - sqrt(R2^2 - distance^2 / 4), the wedge that two
 *    discs leave beside them, whichever is larger: r = 0, and moves across the axis;
 *  - distance: the raised cutter is inside itself;
 *  and, if the flank is inclined, not less than the step of its upper edge and the wedge of the shank above
 *  it together. Exact for balls. */
double sweptError(const CutterProfile& profile, double height, double distance);

/** The place of a cutter: tip and unit axis. */
struct CutterPlace {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
};

/** The same for any two places, if tip and axis change evenly from one to the other. The corner's circle gives
 *  height and distance about the mean axis. The motion beyond that circle from the turn of the axis, and the bow of
 *  its arc, are added. */
double sweptError(const CutterProfile& profile, const CutterPlace& from, const CutterPlace& to);

} // namespace pcl_spiral
