// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points that hang together with the surface hardly or not at all.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points of no triangle, those of specks (parts of less than 0.005 of the triangles), and tips of spikes: points of the rim
 *  1.25 spacings or more from every other, as the spacing of one-sided neighbourhoods counts, 1.8 of the true ones. Of an
 *  evenly random scan that leaves less than one point of the rim in a hundred out, so it is meant for scans that have
 *  outliers. Original indices, ascending. */
std::vector<std::uint32_t> lonePoints(const SurfaceGraph& graph);

/** Points 2.5 usual spacings or more from their neighbours that belong to no triangle, or to none of a part of 0.02 of the
 *  triangles or more: echoes high off the surface, whose nearest neighbours are each other; and tips of long spikes: points of
 *  the rim five spacings or more from all they share a triangle with, none of which is sparse. None of an evenly spread scan,
 *  nor of one with a sparser part, which is larger. Original indices, ascending. */
std::vector<std::uint32_t> sparseSpecks(const SurfaceGraph& graph);

} // namespace pcl_spiral
