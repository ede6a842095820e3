// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points for a gap in the data, from a smooth patch fitted around it.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** What was put into one gap. */
struct GapFill {
  std::vector<Eigen::Vector3f> points; ///< on the patch, at the cloud's spacing; empty if nothing could be fitted
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double width = 0.0;    ///< largest extent of the gap, mm
  double residual = 0.0; ///< rms distance of the points around the gap from the patch, mm
};

/** Fill the gap inside a closed \p loop of boundary points with points of a bicubic patch, fitted by least squares
 *  to the cloud within one gap's width of it. Only for gaps over which the surface is smooth. */
GapFill fillGap(const SurfaceGraph& graph, const Polyline& loop);

/** How many points of the cloud lie inside \p loop and more than 1.5 spacings from it: none if it is a gap. */
std::size_t pointsInside(const SurfaceGraph& graph, const Polyline& loop);

} // namespace pcl_spiral
