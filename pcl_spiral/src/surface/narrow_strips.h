// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Strips of a surface that are too narrow to be cut, where points were taken out of it. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One flag per point of the graph: 1 if it is \p kept, and in a strip narrower than \p width, mm, that the points which are not kept have
 *  left of a wider place: no path runs along such a strip. What was as narrow before stays. */
std::vector<std::uint8_t> narrowStrips(const SurfaceGraph& graph, const std::vector<std::uint8_t>& kept, double width);

} // namespace pcl_spiral
