// SPDX-License-Identifier: BSD-3-Clause
#include "dijkstra_tree.h"

#include "mesh_walk.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace pcl_spiral {

bool
DijkstraTree::compute(const SurfaceGraph& graph, const Eigen::Vector3d& source)
{
  graph_ = &graph;
  edges_ = nullptr;
  source_ = source;
  return search();
}

bool
DijkstraTree::compute(const SurfaceGraph& graph, const NeighbourLists& edges, const Eigen::Vector3d& source)
{
  graph_ = &graph;
  edges_ = &edges;
  source_ = source;
  return search();
}

bool
DijkstraTree::hasEdges(std::uint32_t v) const
{
  return edges_ ? (*edges_)[v].size() > 0 : hasTriangles(graph_->triangulation(), v);
}

/** Call \p visit(j) for every point j that an edge joins to \p v. */
template <typename Visit>
void
DijkstraTree::forEdges(std::uint32_t v, Visit visit) const
{
  if (!edges_) {
    forNeighbours(graph_->triangulation(), v, visit);
    return;
  }
  for (const std::uint32_t j : (*edges_)[v])
    visit(j);
}

bool
DijkstraTree::search()
{
  const SurfaceGraph& graph = *graph_;
  distances_.assign(graph.size(), unreached);
  before_.assign(graph.size(), Triangulation::none);
  const std::uint32_t nearest = nearestPoint(graph, source_, reachOf(graph), [&](std::uint32_t i) { return hasEdges(i); });
  if (nearest == Triangulation::none)
    return false;
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](std::uint32_t point, double distance, std::uint32_t before) {
    if (distance < distances_[point]) {
      distances_[point] = distance;
      before_[point] = before;
      queue.emplace(distance, point);
    }
  };
  const auto straight = [&](std::uint32_t j) { reach(j, (graph.position(j) - source_).norm(), Triangulation::none); };
  straight(nearest);
  forEdges(nearest, straight);
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances_[v])
      continue;
    const Eigen::Vector3d from = graph.position(v);
    forEdges(v, [&, distance = distance, v = v](std::uint32_t j) { reach(j, distance + (graph.position(j) - from).norm(), v); });
  }
  return true;
}

Polyline
DijkstraTree::path(const Eigen::Vector3d& to) const
{
  const std::uint32_t nearest =
      graph_ ? nearestPoint(*graph_, to, reachOf(*graph_), [&](std::uint32_t i) { return distances_[i] < unreached; })
             : Triangulation::none;
  if (nearest == Triangulation::none)
    return {};
  const auto through = [&](std::uint32_t j) { return distances_[j] + (graph_->position(j) - to).norm(); };
  std::uint32_t last = nearest;
  bool beside_source = before_[nearest] == Triangulation::none;
  forEdges(nearest, [&](std::uint32_t j) {
    if (through(j) < through(last))
      last = j;
    beside_source = beside_source && before_[j] == Triangulation::none;
  });
  Polyline line{to};
  for (std::uint32_t v = beside_source ? Triangulation::none : last; v != Triangulation::none; v = before_[v])
    line.push_back(graph_->position(v));
  line.push_back(source_);
  std::reverse(line.begin(), line.end());
  return line;
}

} // namespace pcl_spiral
