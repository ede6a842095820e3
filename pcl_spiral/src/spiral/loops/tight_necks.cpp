// SPDX-License-Identifier: BSD-3-Clause
#include "tight_necks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double least_way = 1.0; // step-overs along a loop between two points of a neck
constexpr double apart = 0.2;     // step-overs between the axes of a long neck

struct LoopPoint {
  std::uint32_t loop, point;
};

using Cell = std::array<std::int64_t, 3>;

/** Points of loops in cells. Cells share buckets through a hash. */
class LoopGrid {
public:
  LoopGrid(const std::vector<RawLoop>& loops, double edge) : loops_(loops), edge_(edge)
  {
    std::vector<Entry> found;
    for (std::uint32_t l = 0; l < loops.size(); ++l)
      for (std::uint32_t i = 0; i < loops[l].line.points.size(); ++i)
        if (loops[l].is_fine[i])
          found.push_back({cellOf(loops[l].line.points[i]), {l, i}});
    while (mask_ < found.size())
      mask_ = 2 * mask_ + 1;
    begin_.resize(mask_ + 2, 0);
    for (const Entry& entry : found)
      ++begin_[bucketOf(entry.cell) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    entries_.resize(found.size());
    for (const Entry& entry : found)
      entries_[next[bucketOf(entry.cell)]++] = entry;
  }

  template <typename Visit>
  void forNear(const Eigen::Vector3d& p, const Visit& visit) const
  {
    const Cell c = cellOf(p);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const Cell near{c[0] + x, c[1] + y, c[2] + z};
          const std::size_t bucket = bucketOf(near);
          for (std::uint32_t k = begin_[bucket]; k < begin_[bucket + 1]; ++k)
            if (const Cell& cell = entries_[k].cell; cell[0] == near[0] && cell[1] == near[1] && cell[2] == near[2]) // no call
              visit(entries_[k].point);
        }
  }

private:
  struct Entry {
    Cell cell;
    LoopPoint point;
  };

  Cell cellOf(const Eigen::Vector3d& p) const
  {
    return {static_cast<std::int64_t>(std::floor(p.x() / edge_)), static_cast<std::int64_t>(std::floor(p.y() / edge_)),
            static_cast<std::int64_t>(std::floor(p.z() / edge_))};
  }
  std::size_t bucketOf(const Cell& c) const
  {
    return static_cast<std::size_t>(c[0] * 73856093 ^ c[1] * 19349663 ^ c[2] * 83492791) & mask_;
  }

  const std::vector<RawLoop>& loops_;
  double edge_;
  std::size_t mask_ = 1;
  std::vector<std::uint32_t> begin_; ///< in entries_, of each bucket; and the end
  std::vector<Entry> entries_;       ///< by buckets, in each in the order of the loops
};

/** Whether a neck lies between two points of loops, each on the inner side of the other. */
bool
isNeck(const RawLoop& a, std::size_t i, const RawLoop& b, std::size_t j, double width)
{
  const Eigen::Vector3d d = b.line.points[j] - a.line.points[i];
  if (a.line.metric[i].length(d) > width || a.uphill[i].dot(d) <= 0.0 || b.uphill[j].dot(d) >= 0.0)
    return false;
  const double way = std::abs(a.line.arcs[i] - b.line.arcs[j]);
  return &a != &b || std::min(way, a.line.length() - way) > least_way;
}

} // namespace

std::vector<FingerAxis>
tightNecks(const std::vector<RawLoop>& loops, double width)
{
  double edge = 0.0;
  for (const RawLoop& loop : loops)
    for (std::size_t i = 0; i < loop.line.metric.size(); ++i)
      if (loop.is_fine[i])
        edge = std::max(edge, width * longestStepOver(loop.line.metric[i]));
  std::vector<FingerAxis> axes;
  if (edge == 0.0)
    return axes;
  const LoopGrid grid(loops, edge);
  const auto add = [&](const RawLoop& a, std::size_t i, const RawLoop& b, std::size_t j) {
    const Eigen::Vector3d middle = 0.5 * (a.line.points[i] + b.line.points[j]);
    const StepOverMetric& metric = a.line.metric[i];
    for (const FingerAxis& axis : axes)
      if (metric.length(axis.points.front() - middle) < apart)
        return;
    axes.push_back({{middle}, {metric}});
  };
  for (std::uint32_t l = 0; l < loops.size(); ++l)
    for (std::uint32_t i = 0; i < loops[l].line.points.size(); ++i)
      if (loops[l].is_fine[i])
        grid.forNear(loops[l].line.points[i], [&](const LoopPoint& q) {
          if (std::make_pair(l, i) < std::make_pair(q.loop, q.point) && isNeck(loops[l], i, loops[q.loop], q.point, width))
            add(loops[l], i, loops[q.loop], q.point);
        });
  return axes;
}

} // namespace pcl_spiral
