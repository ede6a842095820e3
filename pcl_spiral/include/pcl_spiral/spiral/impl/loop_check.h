// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks whether the user's own loops belong to a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Ok if \p loop, number \p index of those given, has points, a curve of three or more points, and corners among them. */
Status checkLoopShape(const BoundaryLoop& loop, std::size_t index);

/** The same. Also all points are finite and within a few spacings of the cloud, and the surface lies on the left of the loop, seen
 *  from outside the material. An outline drawn across the surface has points on both sides: there an Outer loop must run
 *  counter-clockwise round its inside, any other loop clockwise. */
Status checkLoop(const SurfaceGraph& graph, const BoundaryLoop& loop, std::size_t index);

/** Ok if the surface lies on the left of all loops that BoundaryLoops found on it. They have it there along the triangles; where something
 *  hangs over the surface, its own edge has points of the surface below on the other side. The message contains the place. */
Status checkFoundLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops);

/** checkLoop of every loop. The message contains the loop, the place and the remedy. */
Status checkLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops);

} // namespace pcl_spiral
