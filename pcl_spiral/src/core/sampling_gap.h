// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far a cutter sinks between the points of a scan.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

namespace pcl_spiral {

/** A contact on a smooth surface of which only points are known. Lengths in mm. */
struct SampledContact {
  double covering_radius = 0.0; ///< d: every place of the surface is at most this far from the nearest point
  double lean = 0.0;            ///< of the surface's normal to the axis, radians
  double distance = 0.0;        ///< of the contact from the axis
  double curvature = 0.0;       ///< the larger one of the surface, 1/mm, positive where it is convex
};

/** Bound of how much lower, along the axis, a cutter rests on the points than on the surface itself.
 * Infinite if there is no bound: steep walls, and cutters that may pass between the points.
 *
 *  Within D of the contact the cutter covers a point: D = d, or 2 d if the rim of the cutter is nearer
 * than d. There the distance of the cutter from the surface, along the axis, is at most the least of:
 *  - a ball in the corner, of the radius r' with 1 / r' = 1 / r + curvature: b - sqrt(b^2 - D^2), b = r'
 * cos(lean) - D sin(lean), which is D^2 / (2 r) on a level plane, s^2 / (4 r) for points in squares of side
 * s;
 *  - the flat, if it holds a point within 2 d of its edge: the surface falls by at most the lean and
 * its curvature;
 *  - a flank: the profile rises by no more than 1 / tan(alpha). */
double samplingGap(const CutterProfile& profile, const SampledContact& contact);

} // namespace pcl_spiral
