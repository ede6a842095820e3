/** \file
 *  A surface's graph of a raw scan: evenly spread, without outliers.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Which of the points given a graph was built of. */
struct GraphSource {
  std::vector<std::uint32_t> indices; ///< of each point of the graph, by its original index there
  std::vector<std::uint32_t> strays;  ///< left out: off the surface, or apart from it; ascending
  int passes = 0;                     ///< over all neighbourhoods: graphs that were built
  std::size_t surplus = 0;            ///< left out: much closer to others than these to the next, as along scan lines
};

/** Build \p graph of \p points less outliers: strays, sparse specks, false points, and where these are more than one in a thousand
 *  lone points, sought anew after each removal, for an outlier may hide another, up to five times. Where points lie much
 *  closer along scan lines than the lines stand apart, nearly at one place, or beside a much sparser part, some are left
 *  out before, until neighbours lie all about each point; once more when outliers were found, which had others left out
 *  in their favour.
 *  Fails where SurfaceGraph::build does.
 *  \sa evenSpread, SurfaceGraph::strayPoints, sparseSpecks, falsePoints, lonePoints */
Status
buildCleanGraph(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options, SurfaceGraph& graph,
                GraphSource& source);

} // namespace pcl_spiral
