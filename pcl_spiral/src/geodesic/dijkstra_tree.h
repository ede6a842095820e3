// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shortest paths over edges between the points of a surface.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/search/neighbour_lists.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_spiral {

/** Shortest paths over edges from one source to every point (Dijkstra 1959). The edges are those of a graph's triangles, or others.
 *
 *  One search serves all targets. The paths are too long by some percent at any density: use them as a start for
 *  refinement, not as a result. The graph must outlive the tree. Deterministic.
 */
class DijkstraTree {
public:
  static constexpr double unreached = std::numeric_limits<double>::infinity();

  /** Search from a position near the cloud. False, with nothing reached, if it is farther than three spacings away. */
  bool compute(const SurfaceGraph& graph, const Eigen::Vector3d& source);
  /** The same over \p edges between the graph's points, in its order; they must outlive the tree. */
  bool compute(const SurfaceGraph& graph, const NeighbourLists& edges, const Eigen::Vector3d& source);

  std::size_t size() const { return distances_.size(); }
  /** Length of the path to point \p i, mm; unreached if on another part. */
  double distance(std::size_t i) const { return distances_[i]; }
  /** The path from the source to \p to, including both; empty if \p to is off the cloud or not reached. */
  Polyline path(const Eigen::Vector3d& to) const;

private:
  bool search();
  bool hasEdges(std::uint32_t v) const;
  template <typename Visit>
  void forEdges(std::uint32_t v, Visit visit) const;

  const SurfaceGraph* graph_ = nullptr;
  const NeighbourLists* edges_ = nullptr; ///< null: those of the triangles
  Eigen::Vector3d source_ = Eigen::Vector3d::Zero();
  std::vector<double> distances_;
  std::vector<std::uint32_t> before_; ///< the point before each one on its path; none for the first
};

} // namespace pcl_spiral
