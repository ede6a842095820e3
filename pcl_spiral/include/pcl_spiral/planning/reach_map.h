// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The map of the largest balls that reach a surface.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/planning/spiral_plan.h>

#include <vector>

namespace pcl_spiral {

/** Points of a surface, and for each the radius of the largest ball that reaches it, at most largest; mm. */
struct ReachMap {
  Polyline places;          ///< of the points
  std::vector<float> radii; ///< one for each place
  double largest = 0.0;     ///< four tool radii: what a larger ball reaches is not told apart
};

/** Of the part of \p plan, or of its regions. The plan must have its surface, see SpiralPlanner::setKeepSurface.
 *  \throw std::invalid_argument without one */
ReachMap reachMap(const SpiralPlan& plan);

} // namespace pcl_spiral
