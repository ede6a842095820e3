// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Samples a path for linear moves.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Points of \p path. They are so close that linear moves keep the chord error of \p settings, on the surface and at the ball's
 *  centre, and the longest step. Points within a fifth of the chord error of a straight move are left out. \p longest_step: the
 *  longest move allowed anywhere, mm. The first point of each pass is marked. Fails where the path leaves the surface. */
Status samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, std::vector<SpiralPoint>& points,
                  double& longest_step);

} // namespace pcl_spiral
