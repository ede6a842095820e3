// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points close to a surface that are not part of it.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Spikes: points that lie close to the surface, but not on it, such as echoes, dust, spatter. Each is farther from the surface that
 *  its neighbours make without it than six times their noise and 0.03 of the spacing, and at most one of its neighbours is half as
 *  far from its own such surface (along a crease more are, and stay). Original indices, ascending.
 *
 *  The surface is that of ProjectionMethod::RobustQuartic. Leaving the point itself out of its fit gives the deleted
 *  residual of Cook, Detection of influential observation in linear regression, 1977. */
std::vector<std::uint32_t> spikeOutliers(const SurfaceGraph& graph);

} // namespace pcl_spiral
