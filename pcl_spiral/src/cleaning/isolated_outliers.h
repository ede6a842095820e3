// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points with little or no connection to the surface.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points of no triangle, points of clusters (parts with less than 0.005 of the triangles), and tips of spikes: boundary points
 *  1.25 spacings or more from every other. These are spacings of one-sided neighbourhoods, so 1.8 of the true ones. In an
 *  evenly random scan less than one boundary point in a hundred is left out, so this is meant for scans that have
 *  outliers. Original indices, ascending. */
std::vector<std::uint32_t> isolatedOutliers(const SurfaceGraph& graph);

/** Points 2.5 usual spacings or more from their neighbours that belong to no triangle, or only to parts with less than 0.02 of the
 *  triangles: echoes high above the surface, whose nearest neighbours are each other. Also spikes and fans of long triangles, as at a rim:
 *  such points that triangles join to each other, if all of them are five spacings or more from the dense points beside them and none is
 *  surrounded by the others. None in an evenly spread scan, nor in one with a sparser part, three points wide. Original indices,
 *  ascending. */
std::vector<std::uint32_t> sparseClusters(const SurfaceGraph& graph);

} // namespace pcl_spiral
