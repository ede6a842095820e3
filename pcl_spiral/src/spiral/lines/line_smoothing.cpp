// SPDX-License-Identifier: BSD-3-Clause
#include "line_smoothing.h"

#include "segment_set.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pcl_spiral {
namespace {

constexpr std::ptrdiff_t fewest_beside = 2; // points of a fit on either side of its segment
constexpr double largest_variance = 4.0;    // of a fitted point, divided by that of a mean
constexpr std::size_t fewest_points = 12;
constexpr std::size_t most_between = 16; // points that one straight line may skip

/** Places of the new points, the steps apart and even over the closed loop. */
std::vector<double>
newPlaces(const ScallopLoop& loop, const LineGrain& grain, std::vector<std::size_t>& after)
{
  const std::size_t n = loop.points.size();
  std::vector<double> count(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    count[i + 1] = count[i] + (loop.arcs[i + 1] - loop.arcs[i]) * 2.0 / (grain.steps[i] + grain.steps[(i + 1) % n]);
  const auto points = std::max(fewest_points, static_cast<std::size_t>(std::ceil(count[n])));
  std::vector<double> places(points);
  after.resize(points);
  std::size_t i = 0;
  for (std::size_t k = 0; k < points; ++k) {
    const double c = count[n] * static_cast<double>(k) / static_cast<double>(points);
    while (i + 1 < n && count[i + 1] <= c)
      ++i;
    const double share = (c - count[i]) / std::max(count[i + 1] - count[i], 1e-300);
    places[k] = loop.arcs[i] + share * (loop.arcs[i + 1] - loop.arcs[i]);
    after[k] = i;
  }
  return places;
}

/** Weights of the value at t = 0 of the polynomial of \p Degree with the normal equations \p a x = b, if these determine it. The variance
 *  of the value, divided by that of a mean of the same points, is 1.6 for a parabola on evenly spread points. */
template <int Degree>
std::optional<Eigen::Matrix<double, Degree + 1, 1>>
weightsAtMiddle(const Eigen::Matrix3d& a)
{
  using Weights = Eigen::Matrix<double, Degree + 1, 1>;
  const Eigen::Matrix<double, Degree + 1, Degree + 1> part = a.template topLeftCorner<Degree + 1, Degree + 1>();
  const Eigen::LDLT<Eigen::Matrix<double, Degree + 1, Degree + 1>> solver(part);
  const Weights weights = solver.solve(Weights::Unit(0));
  const bool determined = solver.vectorD().minCoeff() > 1e-12 * a(0, 0) && weights(0) * a(0, 0) < largest_variance;
  return determined ? std::optional(weights) : std::nullopt;
}

/** Value at t = 0 of the parabola with the normal equations \p a x = \p b. If the points stand in groups that do not determine a
 *  parabola, the value of the straight line; if they do not determine that, \p known. */
Eigen::Vector3d
valueAtMiddle(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, const Eigen::Vector3d& known)
{
  if (const auto parabola = weightsAtMiddle<2>(a))
    return b.transpose() * *parabola;
  if (const auto line = weightsAtMiddle<1>(a))
    return b.topRows<2>().transpose() * *line;
  return known;
}

/** Middle of the parabola fitted about \p u, which lies on segment \p i. */
Eigen::Vector3d
fitted(const ScallopLoop& loop, double u, std::size_t i, double width)
{
  const auto n = static_cast<std::ptrdiff_t>(loop.points.size());
  const double whole = loop.length();
  const auto place = [n](std::ptrdiff_t j) { return j < 0 ? j + n : j < n ? j : j - n; }; // less than one lap away
  const auto arc = [&](std::ptrdiff_t j) { return loop.arcs[place(j)] + (j < 0 ? -whole : j < n ? 0.0 : whole); };
  const auto at = static_cast<std::ptrdiff_t>(i);
  std::ptrdiff_t first = at, last = at + 1;
  while (first > at - n / 2 && (u - arc(first - 1) < width || at - first < fewest_beside))
    --first;
  while (last < at + n / 2 && (arc(last + 1) - u < width || last - at - 1 < fewest_beside))
    ++last;
  const double reach = std::max({width, 1.001 * (u - arc(first)), 1.001 * (arc(last) - u)});
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero(); // its lower triangle; entry by entry, because small vectors would go through memory
  Eigen::Matrix3d b = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d origin = loop.points[i];
  for (std::ptrdiff_t j = first; j <= last; ++j) {
    const double t = (arc(j) - u) / reach, s = std::abs(t), c = 1.0 - s * s * s;
    const double weight = c * c * c * (arc(j + 1) - arc(j - 1));
    const std::array<double, 3> basis{1.0, t, t * t};
    const Eigen::Vector3d& p = loop.points[place(j)];
    for (int row = 0; row < 3; ++row)
      for (int k = 0; k < 3; ++k) {
        b(row, k) += weight * basis[row] * (p[k] - origin[k]);
        if (k <= row)
          a(row, k) += weight * basis[row] * basis[k];
      }
  }
  return origin + valueAtMiddle(a, b, loop.at(u) - origin);
}

/** Whether the points between \p first and \p last, counted round the loop, lie within \p tolerance of a straight line. */
bool
isStraight(const ScallopLoop& loop, std::size_t first, std::size_t last, double tolerance)
{
  const Eigen::Vector3d& a = loop.points[first];
  const Eigen::Vector3d& b = loop.points[last % loop.points.size()];
  double share = 0.0;
  for (std::size_t k = first + 1; k < last; ++k)
    if (distanceFromSegment(loop.points[k], loop.metric[k], a, b, share) > tolerance)
      return false;
  return true;
}

} // namespace

std::vector<std::size_t>
pointsKept(const ScallopLoop& loop, double tolerance, double longest)
{
  std::vector<std::size_t> kept{0};
  const std::size_t n = loop.points.size();
  for (std::size_t next = 1; next < n; ++next)
    if (next - kept.back() >= most_between || loop.arcs[next + 1] - loop.arcs[kept.back()] > longest ||
        !isStraight(loop, kept.back(), next + 1, tolerance))
      kept.push_back(next);
  return kept;
}

ScallopLoop
smoothed(const ScallopLoop& loop, const LineGrain& grain)
{
  std::vector<std::size_t> from; // the old point before each new one
  const std::vector<double> places = newPlaces(loop, grain, from);
  ScallopLoop line;
  line.level = loop.level;
  line.points.resize(places.size());
  line.metric.resize(places.size());
  const auto count = static_cast<std::int64_t>(places.size());
#pragma omp parallel for schedule(static, 64) if (count > 512)
  for (std::int64_t k = 0; k < count; ++k) {
    const std::size_t i = from[k], next = (i + 1) % loop.points.size();
    const double width = std::min({grain.widths[i], grain.widths[next], loop.length() / 6.0});
    line.points[k] = fitted(loop, places[k], i, width);
    line.metric[k] = loop.metricAt(places[k]);
  }
  line.measure();
  return line;
}

} // namespace pcl_spiral
