// SPDX-License-Identifier: BSD-3-Clause
#include "edge_points.h"

#include <pcl_spiral/core/polyline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_set>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double depth = 4.5; // of the strip along the ring, spacings
constexpr double reach = 7.0; // spacings along the triangles from a point of the ring: its edges are up to six long

/** A point of the cloud, and the entry of the ring from which it was reached. */
using Reached = std::pair<std::uint32_t, std::size_t>;

/** Points near the ring, each with the entry to which the way along the triangles is shortest; nearest first. */
std::vector<Reached>
reachedFrom(const SurfaceGraph& graph, const Ring& ring)
{
  struct Way {
    double length;
    std::uint32_t point;
    std::size_t from;
    bool operator<(const Way& other) const { return length > other.length; }
  };
  const Triangulation& mesh = graph.triangulation();
  std::priority_queue<Way> open;
  for (std::size_t i = 0; i < ring.size(); ++i)
    open.push({0.0, ring[i], i});
  std::unordered_set<std::uint32_t> known;
  std::vector<Reached> reached;
  while (!open.empty()) {
    const Way way = open.top();
    open.pop();
    if (!known.insert(way.point).second)
      continue;
    reached.emplace_back(way.point, way.from);
    for (std::size_t i = mesh.outgoingBegin(way.point); i < mesh.outgoingBegin(way.point + 1); ++i)
      for (const std::uint32_t w : mesh.triangle(mesh.outgoing(i) / 3)) {
        const double length = way.length + (graph.position(w) - graph.position(way.point)).norm();
        if (length < reach * graph.spacing() && known.count(w) == 0)
          open.push({length, w, way.from});
      }
  }
  return reached;
}

/** A closed line on which feet are searched near a given entry. */
class RingLine {
public:
  explicit RingLine(Polyline line) : line_(std::move(line)), at_(arcLengths(line_, true)) {}

  /** Place of the foot of \p p on the edges up to \p window from entry \p about in both directions; its distance. */
  std::pair<double, double> foot(const Eigen::Vector3d& p, std::size_t about, double window) const
  {
    const std::size_t n = line_.size();
    std::pair<double, double> best{0.0, std::numeric_limits<double>::infinity()};
    double run = 0.0;
    for (std::size_t i = about, k = 0; k < n && run < window; i = (i + 1) % n, ++k) {
      look(p, i, best);
      run += at_[i + 1] - at_[i];
    }
    run = 0.0;
    for (std::size_t i = (about + n - 1) % n, k = 0; k < n && run < window; i = (i + n - 1) % n, ++k) {
      look(p, i, best);
      run += at_[i + 1] - at_[i];
    }
    return best;
  }

private:
  void look(const Eigen::Vector3d& p, std::size_t i, std::pair<double, double>& best) const
  {
    const Eigen::Vector3d a = line_[i], d = line_[(i + 1) % line_.size()] - a;
    const double f = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    if (const double distance = (p - a - f * d).norm(); distance < best.second)
      best = {std::fmod(at_[i] + f * (at_[i + 1] - at_[i]), at_.back()), distance};
  }

  Polyline line_;
  std::vector<double> at_;
};

} // namespace

std::vector<EdgePoint>
edgePoints(const SurfaceGraph& graph, const Ring& ring)
{
  Polyline positions;
  for (const std::uint32_t v : ring)
    positions.push_back(graph.position(v));
  const RingLine line(std::move(positions));
  const std::vector<Reached> reached = reachedFrom(graph, ring);
  std::vector<std::pair<double, double>> feet(reached.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(reached.size()); ++i)
    feet[i] = line.foot(graph.position(reached[i].first), reached[i].second, reach * graph.spacing());
  std::vector<EdgePoint> points;
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (feet[i].second < depth * graph.spacing())
      points.push_back({graph.position(reached[i].first), feet[i].first});
  std::stable_sort(points.begin(), points.end(), [](const EdgePoint& a, const EdgePoint& b) { return a.place < b.place; });
  return points;
}

} // namespace pcl_spiral
