// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface of the part of a scan, for passes.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>

namespace pcl_spiral {

/** Removes the outliers from the points of \p plan, with a warning. */
Status leaveOutStrays(unsigned int threads, PassPlan& plan);

/** Makes the surface of the points of \p plan; null if they form none: each stage says why then. Fails if \p settings do not fit them, or
 *  when cancelled. */
Status makePartSurface(const SurfaceSettings& settings, const ProgressCallback& progress, PassPlan& plan);

/** Refuses clusters that stand on the surface of \p plan, with ClusterHandling::LeaveOut removes them from its points and makes the surface
 *  again, and warns of those that stay, which a cutter with the corner radius \p corner_radius rides over. */
Status applyClusterHandling(const SurfaceSettings& settings, double corner_radius, const ProgressCallback& progress, PassPlan& plan);

} // namespace pcl_spiral
