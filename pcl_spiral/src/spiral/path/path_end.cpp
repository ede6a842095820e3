// SPDX-License-Identifier: BSD-3-Clause
#include "path_end.h"

#include "moves_cross.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double tail = 5.0;           // step-overs at an end that may be cut
constexpr double searched = 60.0;      // step-overs of the path before it that are searched
constexpr double searched_turns = 1.5; // and at least this many turns
constexpr double clear = 0.12;
constexpr std::size_t fewest = 3; // points left

/** The number of points to remove at one end of a pass: from the place where one of the last moves crosses another of the pass. */
std::size_t
surplusPoints(const LinkedPath& path, const PassRange& pass, bool at_end)
{
  const std::size_t n = pass.end - pass.begin;
  const auto index = [&](std::size_t k) { return at_end ? pass.end - 1 - k : pass.begin + k; }; // counted from that end
  const auto point = [&](std::size_t k) -> const Eigen::Vector3d& { return path.points[index(k)]; };
  std::vector<double> way{0.0}; // from the end
  const auto wayTo = [&](std::size_t k) {
    for (std::size_t i = way.size(); i <= k; ++i)
      way.push_back(way[i - 1] + between(path.metric[index(i)], path.metric[index(i - 1)], 0.5).length(point(i - 1) - point(i)));
    return way[k];
  };
  const auto turned = [&](std::size_t k) { return std::abs(path.turns[index(k)] - path.turns[index(0)]); };
  std::size_t last = 0, farthest = 0;
  while (last + 1 < n && wayTo(last + 1) < tail)
    ++last;
  while (farthest + 1 < n && (wayTo(farthest + 1) < searched || turned(farthest + 1) < searched_turns))
    ++farthest;
  for (std::size_t k = std::min(last, n - std::min(n, fewest + 1)); k > 0; --k)
    for (std::size_t j = k + 3; j <= farthest; ++j)
      if (movesCross(point(k), point(k - 1), point(j), point(j - 1))) {
        std::size_t kept = k;
        while (kept + fewest + 1 < n && wayTo(kept) - wayTo(k) < clear)
          ++kept;
        return kept;
      }
  return 0;
}

template <typename Values>
void
cut(std::size_t first, std::size_t count, Values& values)
{
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(first + count));
}

void
cutPoints(std::size_t first, std::size_t count, std::size_t pass, LinkedPath& path)
{
  cut(first, count, path.points);
  cut(first, count, path.metric);
  cut(first, count, path.turns);
  cut(first, count, path.reversed);
  for (std::size_t later = pass; later < path.passes.size(); ++later)
    path.passes[later] -= count;
}

} // namespace

void
trimEnd(LinkedPath& path)
{
  const std::vector<PassRange> passes = passRanges(path.passes, path.points.size());
  for (std::size_t p = passes.size(); p-- > 0;) {
    PassRange pass = passes[p];
    const std::size_t behind = surplusPoints(path, pass, true);
    cutPoints(pass.end - behind, behind, p, path);
    pass.end -= behind;
    if (p > 0) // the first begins on the rim
      cutPoints(pass.begin, surplusPoints(path, pass, false), p, path);
  }
}

} // namespace pcl_spiral
