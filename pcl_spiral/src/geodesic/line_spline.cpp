// SPDX-License-Identifier: BSD-3-Clause
#include "line_spline.h"

#include "core/tridiagonal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Second derivatives at all points from the tridiagonal continuity conditions; no chord may vanish. */
Polyline
secondDerivatives(const Polyline& points, const std::vector<double>& chords)
{
  const std::size_t n = points.size();
  if (n < 3)
    return Polyline(n, Eigen::Vector3d::Zero());
  std::vector<TridiagonalRow> rows(n);
  Polyline right(n, Eigen::Vector3d::Zero());
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double a = chords[i - 1], b = chords[i];
    TridiagonalRow& row = rows[i];
    row = {a, 2.0 * (a + b), b};
    if (n == 3)
      row.diagonal += a + b; // one parabola
    else if (i == 1) {
      row.diagonal += a + a * a / b;
      row.after -= a * a / b;
      row.before = 0.0;
    }
    else if (i + 2 == n) {
      row.diagonal += b + b * b / a;
      row.before -= b * b / a;
      row.after = 0.0;
    }
    right[i] = 6.0 * ((points[i + 1] - points[i]) / b - (points[i] - points[i - 1]) / a);
  }
  Polyline m = solveInnerPoints(rows, right);
  m[0] = n == 3 ? m[1] : Eigen::Vector3d(m[1] + (m[1] - m[2]) * chords[0] / chords[1]);
  m[n - 1] = n == 3 ? m[1] : Eigen::Vector3d(m[n - 2] + (m[n - 2] - m[n - 3]) * chords[n - 2] / chords[n - 3]);
  return m;
}

} // namespace

LineSpline::LineSpline(const Polyline& points) : points_(points), lengths_(points.size(), 0.0)
{
  chords_.resize(points.size() - 1);
  for (std::size_t i = 0; i < chords_.size(); ++i)
    chords_[i] = std::max(1e-12, (points[i + 1] - points[i]).norm());
  second_ = secondDerivatives(points, chords_);
  const double off = std::sqrt(15.0) / 10.0; // Gauss-Legendre, three points
  for (std::size_t i = 0; i < chords_.size(); ++i)
    lengths_[i + 1] =
        lengths_[i] + chords_[i] / 18.0 *
                          (5.0 * derivative(i, 0.5 - off).norm() + 8.0 * derivative(i, 0.5).norm() + 5.0 * derivative(i, 0.5 + off).norm());
}

Eigen::Vector3d
LineSpline::derivative(std::size_t i, double f) const
{
  const double e = 1.0 - f, h = chords_[i];
  return (points_[i + 1] - points_[i]) / h + h / 6.0 * ((3.0 * f * f - 1.0) * second_[i + 1] - (3.0 * e * e - 1.0) * second_[i]);
}

Eigen::Vector3d
LineSpline::position(std::size_t i, double f) const
{
  const double e = 1.0 - f, h = chords_[i];
  return e * points_[i] + f * points_[i + 1] + h * h / 6.0 * ((e * e * e - e) * second_[i] + (f * f * f - f) * second_[i + 1]);
}

Polyline
LineSpline::resampled(std::size_t count) const
{
  Polyline result(count);
  std::size_t segment = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = length() * static_cast<double>(i) / static_cast<double>(count - 1);
    while (segment + 2 < lengths_.size() && lengths_[segment + 1] < at)
      ++segment;
    const double whole = lengths_[segment + 1] - lengths_[segment];
    result[i] = position(segment, whole > 0.0 ? std::min(1.0, (at - lengths_[segment]) / whole) : 0.0);
  }
  result.front() = points_.front();
  result.back() = points_.back();
  return result;
}

} // namespace pcl_spiral
