// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points close to a surface that are none of it.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points that lie close to the surface, not on it: echoes, dust, spatter. Each is farther off the surface that its
 *  neighbours make without it than six times their scatter and 0.03 of the spacing, and of its neighbours at most one
 *  other is half as far off theirs (along a crease more are, and stay). Original indices, ascending.
 *
 *  The surface is that of ProjectionMethod::RobustQuartic; leaving the point itself out of its fit is the deleted
 *  residual of Cook, Detection of influential observation in linear regression, 1977. */
std::vector<std::uint32_t> falsePoints(const SurfaceGraph& graph);

} // namespace pcl_spiral
