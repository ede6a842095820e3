/** \file
 *  Whether loops from outside belong to a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/search/surface_graph.h>

#include <vector>

namespace pcl_spiral {

/** Ok when every loop is closed of at least three finite points, stays within a few spacings of the cloud, and has the
 *  surface on its left, seen from outside the material. Otherwise the message names the loop, the place and the remedy. */
Status
checkLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops);

} // namespace pcl_spiral
