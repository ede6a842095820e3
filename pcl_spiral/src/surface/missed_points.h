// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a scan that the fit cuts off. Private.
 */
#pragma once

#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/impl/missed_points.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Missed points of \p graph, whose points stand out of the fit by \p heights: single ones, and those that stand out of noise together with
 *  the points about them. */
MissedPoints missedPoints(const SurfaceGraph& graph, const std::vector<float>& heights);

/** The same, fitting only where it must: at every 16th point, which tells the usual height, and where a point stands out of the arcs from
 *  its neighbours by a fifth of the least height that counts. Only single ones are found: the others take the heights of all points. */
MissedPoints missedPoints(const SurfaceGraph& graph, const MlsSurface& fit);

/** Counts a point that stands \p height out of the fit at \p place, if it is missed. */
void countIfMissed(double height, const Eigen::Vector3d& place, MissedPoints& missed);

} // namespace pcl_spiral
