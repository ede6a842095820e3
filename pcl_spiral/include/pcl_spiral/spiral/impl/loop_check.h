/** \file
 *  Whether loops from outside belong to a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Ok when \p loop, number \p index of those given, has points, a curve of three points or more, and corners among them. */
Status
checkLoopShape(const BoundaryLoop& loop, std::size_t index);

/** The same, and all points are finite and within a few spacings of the cloud, and the surface lies on the loop's left, seen
 *  from outside the material. An outline drawn across the surface has points on both sides: there an Outer loop goes round
 *  its inside counter-clockwise, any other clockwise. */
Status
checkLoop(const SurfaceGraph& graph, const BoundaryLoop& loop, std::size_t index);

/** checkLoop of every loop. The message names the loop, the place and the remedy. */
Status
checkLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops);

} // namespace pcl_spiral
