/** \file
 *  A surface's graph without the points that stand alone off it.
 */
#pragma once

#include <pcl_spiral/search/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Which of the points given a graph was built of. */
struct GraphSource {
  std::vector<std::uint32_t> indices; ///< of each point of the graph, by its original index there
  std::size_t strays = 0;             ///< left out: alone off the surface
  std::size_t surplus = 0;            ///< left out: much closer to others than these to the next, as along scan lines
};

/** Build \p graph of \p points less its stray points, sought anew after each removal, for an outlier may hide another, up
 *  to three times. Where points lie much closer along scan lines than the lines stand apart, nearly at one place, or beside
 *  a much sparser part, some are left out before, until neighbours lie all about each point. Fails where
 *  SurfaceGraph::build does. */
Status
buildWithoutStrays(std::vector<Eigen::Vector3f> points, SurfaceGraphOptions options, SurfaceGraph& graph,
                   GraphSource& source);

} // namespace pcl_spiral
