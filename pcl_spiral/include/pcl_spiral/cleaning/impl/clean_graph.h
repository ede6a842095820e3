// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes the graph of the surface of a raw scan: evenly spread, without outliers.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** Which of the given points a graph was built from. */
struct GraphSource {
  std::vector<std::uint32_t> indices;  ///< of each point of the graph in the given points, by its original index
  std::vector<std::uint32_t> outliers; ///< left out: off the surface, or apart from it; ascending
  int passes = 0;                      ///< over all neighbourhoods: number of graphs built
  std::size_t surplus = 0;             ///< left out: much closer together than the points around them, as along scan lines
};

/** Says whether a cloud, in spatial order, may be a surface. */
using CloudCheck = std::function<Status(const PointBlocks&)>;

/** Build \p graph from \p points without outliers: isolated points, sparse clusters, spikes, and if these are more than one in a
 *  thousand, those of isolatedOutliers. The search is repeated after each removal, up to five times, because an outlier may hide another.
 *  Before that, some points are left out until every point has neighbours all round: where points lie much closer along scan lines
 *  than the lines are apart, nearly at one place, or beside a much sparser part. This is done once more if outliers were found,
 *  because they had others left out in their favour.
 *  Fails where \p check fails, which is called before all else, and where SurfaceGraph::build fails.
 *  \sa evenSpread, SurfaceGraph::isolatedPoints, sparseClusters, spikeOutliers, isolatedOutliers */
Status buildCleanGraph(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options, SurfaceGraph& graph, GraphSource& source,
                       const CloudCheck& check = {});

} // namespace pcl_spiral
