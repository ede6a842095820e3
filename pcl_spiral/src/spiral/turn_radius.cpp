#include "turn_radius.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double reach = 0.12; // step-overs on either side
constexpr double share = 1e-3; // of the path that may turn more sharply

/** Radius of the circle through the corners of a triangle with these sides; infinite on a line. */
double
circumradius(double a, double b, double c)
{
  const double s = 0.5 * (a + b + c), squared = s * (s - a) * (s - b) * (s - c);
  return squared > 0.0 ? a * b * c / (4.0 * std::sqrt(squared)) : std::numeric_limits<double>::infinity();
}

} // namespace

SharpTurns
sharpTurns(const LinkedPath& path)
{
  SharpTurns turns;
  const std::size_t n = path.points.size();
  std::vector<double> arcs(n, 0.0);
  for (std::size_t i = 1; i < n; ++i)
    arcs[i] = arcs[i - 1] + path.metric[i].length(path.points[i] - path.points[i - 1]);
  if (n < 3 || arcs.back() < 2.0 * reach)
    return turns;
  const auto at = [&](double s) -> Eigen::Vector3d {
    const auto next = static_cast<std::size_t>(std::upper_bound(arcs.begin() + 1, arcs.end() - 1, s) - arcs.begin());
    return path.points[next - 1] + (s - arcs[next - 1]) / (arcs[next] - arcs[next - 1]) * (path.points[next] - path.points[next - 1]);
  };
  const auto count = static_cast<std::int64_t>(arcs.back() / (0.5 * reach));
  std::vector<double> radii(static_cast<std::size_t>(count) + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> places(radii.size());
#pragma omp parallel for schedule(static, 1024)
  for (std::int64_t k = 2; k <= count - 2; ++k) {
    const double s = 0.5 * reach * static_cast<double>(k);
    places[k] = static_cast<std::size_t>(std::upper_bound(arcs.begin(), arcs.end() - 1, s) - arcs.begin());
    const StepOverMetric& metric = path.metric[places[k]];
    const Eigen::Vector3d before = at(s - reach), here = at(s), behind = at(s + reach);
    radii[k] = circumradius(metric.length(here - before), metric.length(behind - here), metric.length(behind - before));
  }
  const auto least = std::min_element(radii.begin(), radii.end());
  turns.sharpest = places[static_cast<std::size_t>(least - radii.begin())];
  turns.least_radius = *least;
  const auto quantile = radii.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(radii.size()));
  std::nth_element(radii.begin(), quantile, radii.end());
  turns.radius = *quantile;
  return turns;
}

} // namespace pcl_spiral
