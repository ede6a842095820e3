// SPDX-License-Identifier: BSD-3-Clause
#include "turn_radius.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double reach = 0.12; // step-overs on either side
constexpr double share = 1e-3; // of the path that may bend more sharply

/** Radius of the circle through the corners of a triangle with these sides; infinite on a line. */
double
circumradius(double a, double b, double c)
{
  const double s = 0.5 * (a + b + c), squared = s * (s - a) * (s - b) * (s - c);
  return squared > 0.0 ? a * b * c / (4.0 * std::sqrt(squared)) : std::numeric_limits<double>::infinity();
}

} // namespace

SharpTurns
sharpTurns(const LinkedPath& path, double rim)
{
  SharpTurns turns;
  const std::size_t n = path.points.size();
  std::vector<double> arcs(n, 0.0);
  const std::vector<PassRange> passes = passRanges(path.passes, n);
  const auto count = static_cast<std::int64_t>(n);
#pragma omp parallel for schedule(static, 1024)
  for (std::int64_t i = 1; i < count; ++i)
    arcs[i] = beginsPass(path.passes, i) ? 0.0 : path.metric[i].length(path.points[i] - path.points[i - 1]);
  std::partial_sum(arcs.begin(), arcs.end(), arcs.begin());
  if (n < 3 || arcs.back() < 2.0 * reach)
    return turns;
  const auto at = [&](double s, std::size_t next) -> Eigen::Vector3d { // looked for from point next on
    while (next > 1 && arcs[next - 1] > s)
      --next;
    while (next + 1 < n && arcs[next] <= s)
      ++next;
    return path.points[next - 1] + (s - arcs[next - 1]) / (arcs[next] - arcs[next - 1]) * (path.points[next] - path.points[next - 1]);
  };
  std::vector<std::pair<double, std::size_t>> radii(n, {std::numeric_limits<double>::infinity(), 0}); // moves between points are straight
#pragma omp parallel for schedule(static, 1024)
  for (std::int64_t i = 1; i < count - 1; ++i) {
    const PassRange& pass = passes[passOf(path.passes, static_cast<std::size_t>(i))];
    if (arcs[i] < std::max(rim, arcs[pass.begin] + reach) || arcs[i] > arcs[pass.end - 1] - reach)
      continue;
    const StepOverMetric& metric = path.metric[i];
    const Eigen::Vector3d before = at(arcs[i] - reach, i), &here = path.points[i], behind = at(arcs[i] + reach, i);
    radii[i] = {circumradius(metric.length(here - before), metric.length(behind - here), metric.length(behind - before)),
                static_cast<std::size_t>(i)};
  }
  const std::greater<> larger;
  std::make_heap(radii.begin(), radii.end(), larger); // few of the smallest are taken
  turns.least_radius = radii.front().first;
  turns.sharpest = radii.front().second;
  double turned = 0.0;
  for (auto end = radii.end(); end != radii.begin() && !(turned > share * arcs.back()); --end) {
    const auto [radius, i] = radii.front();
    turns.radius = radius;
    turned += std::min(reach, 0.5 * (arcs[std::min(n - 1, i + 1)] - arcs[i > 0 ? i - 1 : 0]));
    std::pop_heap(radii.begin(), end, larger);
  }
  return turns;
}

} // namespace pcl_spiral
