// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From published lines to a path on the surface. Private to spiral.
 */
#pragma once

#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/spiral/impl/published_spiral.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>

#include <functional>
#include <vector>

namespace pcl_spiral {

/** The turns between result.lines at the step-over of (16), by arc length along the lines ((17)-(19)), in
 *  steps of (13)-(15). All three are stored in result.figures. */
Status publishedCurve(const SurfaceGraph& graph, const SpiralSettings& settings, PublishedResult& result, std::vector<SpiralPoint>& curve);

/** Project the curve onto the surface by (8)-(11); normals are PCA normals of the nearest points. \p progress: share
 *  done; false cancels. */
Status publishedContacts(const MlsSurface& surface, const SpiralSettings& settings, const std::vector<SpiralPoint>& curve,
                         const std::function<bool(double)>& progress, PublishedResult& result);

/** Axes: the normals tilted about the feed and led about the conormal, not smoothed. */
void publishedAxes(const SpiralSettings& settings, PublishedResult& result);

} // namespace pcl_spiral
