/** \file
 *  A surface's graph without the points that stand alone off it.
 */
#pragma once

#include <pcl_spiral/search/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Build \p graph of \p points less its stray points, sought anew after each removal, for an outlier may hide another, up
 *  to three times. \p source: which of the points given is each of those that the graph was built of. Fails where
 *  SurfaceGraph::build does. */
Status
buildWithoutStrays(std::vector<Eigen::Vector3f> points, SurfaceGraphOptions options, SurfaceGraph& graph,
                   std::vector<std::uint32_t>& source);

} // namespace pcl_spiral
