// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path lifted off the surface where the ball does not reach it. Private to spiral.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/surface/impl/ball_reach.h>

namespace pcl_spiral {

/** Moves the ball of every point of \p path to its nearest free place, BallReach::centre. Between two points of which one is lifted,
 *  points are added until straight moves of the centre are as near to these places as the chord error allows. If no point is lifted,
 *  the path stays as it is. \p given: reach of the ball on \p surface; null: made here. Fails where there is no free place. */
Status rideTightPlaces(const Surface& surface, const BallReach* given, const SpiralSettings& settings, double longest_step,
                       SpiralPath& path);

} // namespace pcl_spiral
