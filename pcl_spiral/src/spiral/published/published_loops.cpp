// SPDX-License-Identifier: BSD-3-Clause
#include "published_loops.h"

#include "search/neighbour_search.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/features/impl/boundary_evidence.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Tests one point after the other; one object a thread. */
class CentroidTest {
public:
  explicit CentroidTest(const SurfaceGraph& graph) : graph_(graph) {}

  bool isOnBoundary(std::size_t i, const Neighbourhood& near, double offset_threshold)
  {
    Eigen::Vector3d e1, e2;
    tangentFrame(graph_.normal(i), e1, e2);
    offsets_.clear();
    for (int k = 1; k < near.size; ++k) { // the first is the point itself
      const Eigen::Vector3d d(near.x[k], near.y[k], near.z[k]);
      offsets_.emplace_back(d.dot(e1), d.dot(e2));
    }
    const double radius = std::sqrt(static_cast<double>(near.squared_distance[near.size - 1]));
    const BoundaryEvidence evidence = boundaryEvidence(offsets_, radius, angles_);
    // This criterion does not use the gap.
    return isBoundary(evidence, BoundaryCriterion::Centroid, offset_threshold, pi); // (1)
  }

private:
  const SurfaceGraph& graph_;
  std::vector<Eigen::Vector2d> offsets_;
  std::vector<double> angles_;
};

} // namespace

std::vector<std::uint8_t>
centroidFlags(const SurfaceGraph& graph, int neighbours, double offset_threshold)
{
  const PointBlocks& blocks = graph.blocks();
  const auto count = static_cast<std::int64_t>(blocks.blockCount());
  std::vector<std::uint8_t> flags(graph.size(), 0);
#pragma omp parallel
  {
    NeighbourSearch search(blocks, neighbours + 1);
    CentroidTest test(graph);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < count; ++b) {
      search.setRun(blocks.blockBox(b));
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i)
        flags[blocks.originalIndex(i)] = test.isOnBoundary(i, search.find(blocks.position(i)), offset_threshold);
    }
  }
  return flags;
}

Status
publishedLoops(const SurfaceGraph& graph, const PublishedLoopOptions& options, std::vector<BoundaryLoop>& loops)
{
  BoundaryOptions boundary;
  boundary.method = LoopMethod::Walk;
  boundary.max_turn = options.max_turn;
  boundary.marked = centroidFlags(graph, options.neighbours, options.offset_threshold);
  boundary.progress = options.progress;
  return findBoundaryLoops(graph, boundary, loops);
}

} // namespace pcl_spiral
