// SPDX-License-Identifier: BSD-3-Clause
#include "level_islands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

/** Sets of points joined so far, each known by its highest point. */
class Summits {
public:
  Summits(const std::vector<double>& values) : values_(values), parent_(values.size()) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t of(std::uint32_t point)
  {
    while (parent_[point] != point)
      point = parent_[point] = parent_[parent_[point]];
    return point;
  }
  void join(std::uint32_t a, std::uint32_t b)
  {
    a = of(a);
    b = of(b);
    const bool a_is_higher = values_[a] > values_[b] || (values_[a] == values_[b] && a < b);
    parent_[a_is_higher ? b : a] = a_is_higher ? a : b;
  }

private:
  const std::vector<double>& values_;
  std::vector<std::uint32_t> parent_;
};

std::vector<std::uint32_t>
fromHighest(const std::vector<double>& values)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]))
      order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return values[a] > values[b] || (values[a] == values[b] && a < b); });
  return order;
}

} // namespace

LevelIslands
levelIslands(const Triangulation& mesh, const std::vector<double>& values, const std::vector<double>& levels)
{
  LevelIslands found;
  found.of_point.assign(values.size(), LevelIslands::none);
  const std::vector<std::uint32_t> order = fromHighest(values);
  std::vector<std::uint32_t> island_of_summit(values.size(), LevelIslands::none);
  Summits summits(values);
  std::size_t next = 0;
  for (std::size_t k = levels.size(); k-- > 0;) {
    const std::size_t first = next;
    for (; next < order.size() && values[order[next]] >= levels[k]; ++next)
      for (std::uint32_t o = mesh.outgoingBegin(order[next]); o < mesh.outgoingBegin(order[next] + 1); ++o) {
        const std::uint32_t h = mesh.outgoing(o);
        for (const std::uint32_t other : {mesh.target(h), mesh.origin(Triangulation::previous(h))})
          if (std::isfinite(values[other]) && values[other] >= values[order[next]])
            summits.join(order[next], other);
      }
    for (std::size_t i = first; i < next; ++i) {
      const std::uint32_t top = summits.of(order[i]);
      if (k + 1 < levels.size() && values[top] >= levels[k + 1])
        continue;
      if (island_of_summit[top] == LevelIslands::none) {
        island_of_summit[top] = static_cast<std::uint32_t>(found.islands.size());
        found.islands.push_back({k, values[top]});
      }
      found.of_point[order[i]] = island_of_summit[top];
    }
  }
  return found;
}

} // namespace pcl_spiral
