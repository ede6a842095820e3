// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From published lines to a path on the surface. Private to spiral.
 */
#pragma once

#include <pcl_spiral/spiral/impl/published_spiral.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/surface/impl/mls_surface.h>

#include <functional>
#include <vector>

namespace pcl_spiral {

/** The turns between result.lines at the step-over of (16), by arc length along the lines ((17)-(19)), in
 * steps of (13)-(15); all three go into result.figures. */
Status publishedCurve(const SurfaceGraph& graph, const SpiralSettings& settings, PublishedResult& result, std::vector<SpiralPoint>& curve);

/** Put the curve on the surface by (8)-(11); PCA normals of the nearest points. \p progress: share done;
 * false cancels. */
Status publishedContacts(const MlsSurface& surface, const SpiralSettings& settings, const std::vector<SpiralPoint>& curve,
                         const std::function<bool(double)>& progress, PublishedResult& result);

/** The normals tilted about the feed and led about the conormal, as they are. */
void publishedAxes(const SpiralSettings& settings, PublishedResult& result);

} // namespace pcl_spiral
