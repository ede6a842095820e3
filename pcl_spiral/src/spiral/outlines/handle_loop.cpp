// SPDX-License-Identifier: BSD-3-Clause
#include "handle_loop.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr int rounds = 3;
constexpr double rim_cost = 10.0; // of a way along a boundary, which should stay whole

/** Sets of faces, joined one by one. */
class FaceSets {
public:
  explicit FaceSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /** Join the sets of two faces; false if they were one already. */
  bool join(std::size_t a, std::size_t b)
  {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::size_t root(std::size_t f)
  {
    while (parent_[f] != f)
      f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  std::vector<std::size_t> parent_;
};

/** Ways from one node, and the edges that close them over a handle. */
class HandleSearch {
public:
  HandleSearch(const Polyline& positions, const Triangulation& triangles)
  : positions_(positions), triangles_(triangles), face_(triangles.halfEdgeCount()), is_rim_(positions.size(), 0)
  {
    for (std::uint32_t h = 0; h < triangles.halfEdgeCount(); ++h)
      face_[h] = h / 3;
    faces_ = triangles.triangleCount();
    for (const std::vector<std::uint32_t>& rim : triangles.boundaryLoops()) {
      for (const std::uint32_t h : rim) {
        rim_face_.push_back({h, faces_});
        is_rim_[triangles.origin(h)] = 1;
      }
      ++faces_;
    }
    std::sort(rim_face_.begin(), rim_face_.end());
  }

  std::vector<std::uint32_t> loop()
  {
    std::vector<std::uint32_t> best;
    std::uint32_t root = triangles_.origin(0);
    for (int round = 0; round < rounds; ++round) {
      walk(root);
      const std::uint32_t edge = closingEdge();
      if (edge == Triangulation::none)
        return {};
      best = wayOver(edge);
      root = best[best.size() / 2];
    }
    return best;
  }

private:
  bool isEdge(std::uint32_t h) const { return triangles_.opposite(h) == Triangulation::none || h < triangles_.opposite(h); }
  std::size_t faceAcross(std::uint32_t h) const
  {
    const std::uint32_t other = triangles_.opposite(h);
    return other != Triangulation::none ? face_[other]
                                        : std::lower_bound(rim_face_.begin(), rim_face_.end(), std::make_pair(h, std::size_t{0}))->second;
  }
  double cost(std::uint32_t a, std::uint32_t b) const
  {
    return (positions_[a] - positions_[b]).norm() * (is_rim_[a] || is_rim_[b] ? rim_cost : 1.0);
  }
  /** Shortest ways over half-edges from \p root. */
  void walk(std::uint32_t root)
  {
    using Entry = std::pair<double, std::uint32_t>;
    from_.assign(positions_.size(), Triangulation::none);
    cost_.assign(positions_.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    cost_[root] = 0.0;
    front.push({0.0, root});
    const auto reach = [&](std::uint32_t from, std::uint32_t to, std::uint32_t h) {
      const double there = cost_[from] + cost(from, to);
      if (there < cost_[to]) {
        cost_[to] = there;
        from_[to] = h;
        front.push({there, to});
      }
    };
    while (!front.empty()) {
      const auto [d, v] = front.top();
      front.pop();
      if (d > cost_[v])
        continue;
      for (std::size_t o = triangles_.outgoingBegin(v); o < triangles_.outgoingBegin(v + 1); ++o) {
        const std::uint32_t h = triangles_.outgoing(o), before = Triangulation::previous(h);
        reach(v, triangles_.target(h), h);
        reach(v, triangles_.origin(before), before);
      }
    }
  }
  bool isOnWay(std::uint32_t h) const
  {
    const std::uint32_t other = triangles_.opposite(h), a = triangles_.origin(h), b = triangles_.target(h);
    const auto is = [&](std::uint32_t v) { return from_[v] == h || (other != Triangulation::none && from_[v] == other); };
    return is(a) || is(b);
  }
  /** The edge of the shortest closed way that is in neither tree; none if there is no handle. */
  std::uint32_t closingEdge() const
  {
    std::vector<std::pair<double, std::uint32_t>> edges;
    for (std::uint32_t h = 0; h < triangles_.halfEdgeCount(); ++h)
      if (isEdge(h) && !isOnWay(h))
        edges.push_back(
            {-(cost_[triangles_.origin(h)] + cost_[triangles_.target(h)] + cost(triangles_.origin(h), triangles_.target(h))), h});
    std::sort(edges.begin(), edges.end());
    FaceSets faces(faces_);
    std::uint32_t shortest = Triangulation::none;
    for (const auto& [length, h] : edges)
      if (!faces.join(face_[h], faceAcross(h)))
        shortest = h;
    return shortest;
  }
  std::vector<std::uint32_t> wayTo(std::uint32_t v) const
  {
    std::vector<std::uint32_t> way{v};
    while (from_[way.back()] != Triangulation::none) {
      const std::uint32_t h = from_[way.back()];
      way.push_back(triangles_.origin(h) == way.back() ? triangles_.target(h) : triangles_.origin(h));
    }
    std::reverse(way.begin(), way.end());
    return way;
  }
  /** Out to one end of \p edge and back from the other, from the node at which their ways separate. */
  std::vector<std::uint32_t> wayOver(std::uint32_t edge) const
  {
    const std::vector<std::uint32_t> out = wayTo(triangles_.origin(edge)), back = wayTo(triangles_.target(edge));
    std::size_t common = 0;
    while (common < out.size() && common < back.size() && out[common] == back[common])
      ++common;
    std::vector<std::uint32_t> way(out.begin() + static_cast<std::ptrdiff_t>(common - 1), out.end());
    way.insert(way.end(), back.rbegin(), back.rend() - static_cast<std::ptrdiff_t>(common));
    return way;
  }

  const Polyline& positions_;
  const Triangulation& triangles_;
  std::vector<std::size_t> face_;                               ///< of each half-edge
  std::vector<std::pair<std::uint32_t, std::size_t>> rim_face_; ///< of each free half-edge: the face that closes its loop
  std::vector<std::uint8_t> is_rim_;
  std::size_t faces_ = 0;
  std::vector<std::uint32_t> from_; ///< of each node: the half-edge that leads to it or away from it
  std::vector<double> cost_;
};

} // namespace

std::size_t
missingEuler(const Polyline& positions, const Triangulation& triangles)
{
  std::size_t edges = 0, nodes = 0;
  const auto half_edges = static_cast<std::int64_t>(triangles.halfEdgeCount()), points = static_cast<std::int64_t>(positions.size());
#pragma omp parallel for schedule(static) reduction(+ : edges)
  for (std::int64_t h = 0; h < half_edges; ++h)
    edges += triangles.opposite(static_cast<std::uint32_t>(h)) == Triangulation::none ||
             static_cast<std::uint32_t>(h) < triangles.opposite(static_cast<std::uint32_t>(h));
#pragma omp parallel for schedule(static) reduction(+ : nodes)
  for (std::int64_t v = 0; v < points; ++v)
    nodes += triangles.outgoingBegin(v) < triangles.outgoingBegin(v + 1);
  return 2 + edges - nodes - triangles.triangleCount() - triangles.boundaryLoops().size();
}

std::vector<std::uint32_t>
handleLoop(const Polyline& positions, const Triangulation& triangles)
{
  return triangles.triangleCount() == 0 ? std::vector<std::uint32_t>() : HandleSearch(positions, triangles).loop();
}

} // namespace pcl_spiral
