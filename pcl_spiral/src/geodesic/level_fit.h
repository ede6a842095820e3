// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The value of a function of a triangulation's points between and a little beyond them.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <functional>
#include <vector>

namespace pcl_spiral {

/** Value at \p query minus the value at \p start, the point nearest to it: by a quadratic fit, weighted by distance, to
 *  the points reached from \p start over edges. \p growth of the function along a half-edge. */
double fitLevel(const SurfaceGraph& graph, std::uint32_t start, const Eigen::Vector3d& query,
                const std::function<double(std::uint32_t)>& growth);

/** \p levels of the points of a closed run, made to grow (least squares, pool adjacent violators), with the first plus
 *  \p period at the end. */
std::vector<double> growing(const std::vector<double>& levels, double period);

} // namespace pcl_spiral
