#include "path_end.h"

#include "moves_cross.h"

#include <pcl_spiral/core/pass_ranges.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double tail = 5.0;      // step-overs
constexpr double searched = 60.0; // of the path before
constexpr double clear = 0.12;

/** The point after which a pass ends. */
std::size_t
lastPoint(const LinkedPath& path, const PassRange& pass)
{
  const std::size_t n = pass.end;
  std::vector<double> to_end(n - pass.begin, 0.0);
  const auto left = [&](std::size_t i) -> double& { return to_end[i - pass.begin]; };
  for (std::size_t i = n - 1; i > pass.begin; --i)
    left(i - 1) = left(i) + between(path.metric[i - 1], path.metric[i], 0.5).length(path.points[i] - path.points[i - 1]);
  const auto firstWithin = [&](double reach) {
    return pass.begin + static_cast<std::size_t>(std::find_if(to_end.begin(), to_end.end(), [reach](double s) { return s < reach; }) - to_end.begin());
  };
  const std::size_t first = firstWithin(tail), begin = firstWithin(searched), fewest = pass.begin + 3;
  for (std::size_t i = std::max(first, fewest); i + 1 < n; ++i)
    for (std::size_t j = begin; j + 2 < i; ++j)
      if (movesCross(path.points[i], path.points[i + 1], path.points[j], path.points[j + 1])) {
        std::size_t last = i;
        while (last > fewest && left(last) - left(i) < clear)
          --last;
        return last;
      }
  return n - 1;
}

template <typename Values>
void
cut(std::size_t first, std::size_t end, Values& values)
{
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(first), values.begin() + static_cast<std::ptrdiff_t>(end));
}

} // namespace

void
trimEnd(LinkedPath& path)
{
  const std::vector<PassRange> passes = passRanges(path.passes, path.points.size());
  for (std::size_t p = passes.size(); p-- > 0;) {
    const std::size_t first = lastPoint(path, passes[p]) + 1, end = passes[p].end;
    cut(first, end, path.points);
    cut(first, end, path.metric);
    cut(first, end, path.turns);
    cut(first, end, path.reversed);
    for (std::size_t later = p; later < path.passes.size(); ++later)
      path.passes[later] -= end - first;
  }
}

} // namespace pcl_spiral
