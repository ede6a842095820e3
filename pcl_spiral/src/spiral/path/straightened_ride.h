// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The way of the ball over tight places, without turns that the surface does not ask for. Private to spiral.
 */
#pragma once

#include "ridden_point.h"

#include <pcl_spiral/surface/impl/ball_reach.h>

namespace pcl_spiral {

/** How far a straightened way may be from the one before; mm. */
struct RideTolerance {
  double chord_error;  ///< higher over the surface, or deeper in it
  double aside;        ///< from the places of the ball before
  double hairpin;      ///< the same at the end of a hairpin that is cut off
  double longest_step; ///< of a contact
};

/** The same path with straight ways of the ball's centre where it is lifted: each as long as \p tolerance allows. In the corner between two
 *  walls, where the ball rests at one place while its foot moves on from wall to wall, it neither stops nor turns back. Feet and normals of
 *  the points stay; their balls are moved onto the straight way in the order of the path, and points that it does not need are left out. */
RiddenPath straightenedRide(const RiddenPath& path, const BallReach& reach, const RideTolerance& tolerance);

} // namespace pcl_spiral
