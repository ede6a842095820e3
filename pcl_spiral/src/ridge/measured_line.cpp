// SPDX-License-Identifier: BSD-3-Clause
#include "core/median.h"

#include <pcl_spiral/ridge/impl/measured_line.h>

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double largest_gap = 5.0;        // spacings, and the longest side branch
constexpr double largest_join = 2.0;       // spacings between the ends of a closed line
constexpr std::size_t least_ring = 12;     // points
constexpr std::size_t most_points = 20000; // of one line: they take some seconds
constexpr std::uint32_t no_point = 0xffffffffu;

/** The tree of least total length over points, from the first (Prim 1957). */
class LeastTree {
public:
  explicit LeastTree(const Polyline& points) : points_(points), neighbours_(points.size())
  {
    const std::size_t n = points.size();
    std::vector<double> distance(n, std::numeric_limits<double>::infinity());
    std::vector<std::uint32_t> parent(n, no_point);
    std::vector<std::uint8_t> taken(n, 0);
    std::uint32_t next = 0;
    for (std::size_t count = 0; count < n; ++count) {
      const std::uint32_t last = next;
      taken[last] = 1;
      if (parent[last] != no_point)
        join(last, parent[last]);
      double least = std::numeric_limits<double>::infinity();
      for (std::uint32_t i = 0; i < n; ++i) {
        if (taken[i])
          continue;
        if (const double d = (points[i] - points[last]).squaredNorm(); d < distance[i]) {
          distance[i] = d;
          parent[i] = last;
        }
        if (distance[i] < least) {
          least = distance[i];
          next = i;
        }
      }
    }
  }

  const std::vector<double>& lengths() const { return lengths_; }

  /** The ends of the longest edge. */
  std::pair<std::uint32_t, std::uint32_t> longest() const
  {
    return edges_[static_cast<std::size_t>(std::max_element(lengths_.begin(), lengths_.end()) - lengths_.begin())];
  }

  /** The point farthest from \p start along the tree; \p before and \p ways: for all points, the way there and its length. */
  std::uint32_t farthest(std::uint32_t start, std::vector<std::uint32_t>& before, std::vector<double>& ways) const
  {
    before.assign(points_.size(), no_point);
    ways.assign(points_.size(), 0.0);
    std::vector<std::uint32_t> open{start};
    std::uint32_t best = start;
    while (!open.empty()) {
      const std::uint32_t i = open.back();
      open.pop_back();
      if (ways[i] > ways[best])
        best = i;
      for (const std::uint32_t j : neighbours_[i])
        if (j != before[i]) {
          before[j] = i;
          ways[j] = ways[i] + (points_[j] - points_[i]).norm();
          open.push_back(j);
        }
    }
    return best;
  }

private:
  void join(std::uint32_t a, std::uint32_t b)
  {
    neighbours_[a].push_back(b);
    neighbours_[b].push_back(a);
    edges_.emplace_back(a, b);
    lengths_.push_back((points_[a] - points_[b]).norm());
  }

  const Polyline& points_;
  std::vector<std::vector<std::uint32_t>> neighbours_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<double> lengths_;
};

/** The points without repeats, in their order. */
Polyline
withoutRepeats(const Polyline& points)
{
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto less = [&](std::size_t a, std::size_t b) {
    const Eigen::Vector3d &p = points[a], &q = points[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  std::sort(order.begin(), order.end(), less);
  std::vector<std::uint8_t> repeated(points.size(), 0);
  for (std::size_t k = 1; k < order.size(); ++k)
    repeated[order[k]] = points[order[k]] == points[order[k - 1]];
  Polyline result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!repeated[i])
      result.push_back(points[i]);
  return result;
}

/** The line of \p tree: its longest way, with short side branches inserted where they begin. */
Status
lineOf(const LeastTree& tree, const Polyline& points, const Diagnostic& name, MeasuredLine& line)
{
  std::vector<std::uint32_t> before;
  std::vector<double> ways;
  const std::uint32_t start = tree.farthest(0, before, ways);
  const std::uint32_t end = tree.farthest(start, before, ways);
  std::vector<std::uint8_t> on_line(points.size(), 0);
  for (std::uint32_t i = end; i != no_point; i = before[i])
    on_line[i] = 1;
  // Sort key: place on the line where a branch begins; length along the branch; the point itself, so the given order does not matter.
  std::vector<std::tuple<double, double, double, double, double, std::uint32_t>> stations;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t foot = i;
    while (!on_line[foot])
      foot = before[foot];
    if (ways[i] - ways[foot] > largest_gap * line.spacing)
      return {StatusCode::InvalidInput,
              Diagnostic(name, " has a branch at ", Place(points[foot]), ", ", ways[i] - ways[foot],
                         " {mm} long or more: remove what does not belong to the line, or thin points that lie closer than their error")};
    const Eigen::Vector3d& p = points[i];
    stations.emplace_back(ways[foot], ways[i] - ways[foot], p.x(), p.y(), p.z(), i);
  }
  std::sort(stations.begin(), stations.end());
  if (end < start)
    std::reverse(stations.begin(), stations.end());
  for (const auto& station : stations)
    line.points.push_back(points[std::get<5>(station)]);
  return Status::success();
}

} // namespace

Status
orderLine(const Polyline& given, const Diagnostic& name, MeasuredLine& line)
{
  line = MeasuredLine();
  if (given.size() > most_points)
    return {StatusCode::InvalidInput, Diagnostic(name, " has ", given.size(), " points; a line of more than ", most_points,
                                                 " cannot be put in order: is it a whole scan? If not, thin it")};
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!given[i].allFinite())
      return {StatusCode::InvalidInput, Diagnostic("point ", i + 1, " of ", name, " is not finite: remove it")};
  const Polyline points = withoutRepeats(given);
  if (points.size() < 4)
    return {StatusCode::InvalidInput,
            Diagnostic(name, " has ", points.size(), " different points; a line needs at least four: measure more of it")};
  const LeastTree tree(points);
  line.spacing = medianOf(tree.lengths());
  const auto gap = tree.longest();
  const double length = (points[gap.first] - points[gap.second]).norm();
  if (length > largest_gap * line.spacing)
    return {StatusCode::InvalidInput,
            Diagnostic(name, " has a gap of ", length, " {mm} at ", Place(points[std::min(gap.first, gap.second)]), ", more than ",
                       largest_gap, " times the ", line.spacing,
                       " {mm} between its points: measure that piece, or remove the isolated points")};
  if (const Status status = lineOf(tree, points, name, line); !status.ok())
    return status;
  line.closed = line.points.size() >= least_ring && (line.points.front() - line.points.back()).norm() <= largest_join * line.spacing;
  return Status::success();
}

} // namespace pcl_spiral
