/** \file
 *  A path as points that linear moves join.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <vector>

namespace pcl_spiral {

/** Points of \p path so close that linear moves keep the chord error of \p settings, on the surface and for the ball's centre,
 *  and the longest step; points that a straight move passes within a fifth of the chord error are left out. \p longest_step: the
 *  longest move allowed anywhere, mm. Where a pass begins the point is marked. Fails where the path leaves the surface. */
Status
samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, std::vector<SpiralPoint>& points,
           double& longest_step);

} // namespace pcl_spiral
