// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_axes.h"

#include "axis_smoothing.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

constexpr int most_rounds = 20; // of a pass either way: each leaves almost nothing to the next
constexpr double flattest_lean = 89.0 * pi / 180.0;
constexpr double rounding = 1e-9; // of a limit

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** \p from turned by \p angle towards \p to. */
Vector3d
turnedTowards(const Vector3d& from, const Vector3d& to, double angle)
{
  Vector3d side = to - from.dot(to) * from;
  side = side.norm() > 1e-12 ? Vector3d(side.normalized()) : Vector3d(from.unitOrthogonal()); // opposite: in any direction
  return (std::cos(angle) * from + std::sin(angle) * side).normalized();
}

/** Limits the turn on every move. */
class RateLimit {
public:
  RateLimit(const std::vector<double>& s, double max_rate) : limits_(s.size() - 1), chords_(s.size() - 1)
  {
    const auto moves = static_cast<std::int64_t>(limits_.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < moves; ++i) {
      limits_[i] = std::min(pi, max_rate * (s[i + 1] - s[i]));
      const double chord = 2.0 * std::sin(0.5 * limits_[i] * (1.0 + rounding));
      chords_[i] = chord * chord;
    }
  }

  /** Moves on which the turn is above the limit. */
  std::size_t exceeded(const Vectors& axes) const
  {
    std::size_t count = 0;
    const auto moves = static_cast<std::int64_t>(limits_.size());
#pragma omp parallel for schedule(static) reduction(+ : count)
    for (std::int64_t i = 0; i < moves; ++i)
      count += exceeds(i, axes[i], axes[i + 1]);
    return count;
  }

  void apply(Vectors& axes) const
  {
    for (int round = 0; round < most_rounds && exceeded(axes) > 0; ++round) {
      Vectors back = axes;
      forward(axes);
      backward(back);
      if (round + 1 == most_rounds)
        return; // the forward pass alone keeps the limit
      const auto n = static_cast<std::int64_t>(axes.size());
#pragma omp parallel for schedule(static)
      for (std::int64_t i = 0; i < n; ++i)
        if (const Vector3d sum = axes[i] + back[i]; axes[i] != back[i] && sum.norm() > 1e-6)
          axes[i] = sum.normalized();
    }
  }

private:
  bool exceeds(std::size_t move, const Vector3d& a, const Vector3d& b) const
  {
    return (b - a).squaredNorm() > chords_[move] + 1e-24;
  }

  void forward(Vectors& axes) const
  {
    for (std::size_t i = 1; i < axes.size(); ++i)
      if (exceeds(i - 1, axes[i - 1], axes[i]))
        axes[i] = turnedTowards(axes[i - 1], axes[i], limits_[i - 1]);
  }

  void backward(Vectors& axes) const
  {
    for (std::size_t i = axes.size() - 1; i-- > 0;)
      if (exceeds(i, axes[i], axes[i + 1]))
        axes[i] = turnedTowards(axes[i + 1], axes[i], limits_[i]);
  }

  std::vector<double> limits_, chords_; ///< chords squared
};

void
check(const Polyline& points, const Vectors& wanted, const AxisFieldOptions& options)
{
  if (points.size() != wanted.size())
    throw std::invalid_argument("smoothAxes: give one axis per point");
  for (const double option : {options.smoothing_length, options.max_rate})
    if (!(option >= 0.0) || !std::isfinite(option))
      throw std::invalid_argument("smoothAxes: smoothing length and rate must not be negative");
  if (!(options.max_deviation > 0.0))
    throw std::invalid_argument("smoothAxes: the deviation must be above 0");
}

void
measure(const std::vector<double>& s, const Vectors& wanted, double max_deviation, SmoothAxes& result)
{
  const Vectors& axes = result.axes;
  const auto n = static_cast<std::int64_t>(axes.size());
  double largest_deviation = 0.0, largest_change = 0.0, largest_rate = 0.0;
  std::size_t deviating = 0;
#pragma omp parallel for schedule(static) reduction(max : largest_deviation, largest_change, largest_rate) reduction(+ : deviating)
  for (std::int64_t i = 0; i < n; ++i) {
    const double deviation = angleBetween(axes[i], wanted[i]);
    largest_deviation = std::max(largest_deviation, deviation);
    deviating += deviation > max_deviation;
    if (i == 0)
      continue;
    const double turn = angleBetween(axes[i - 1], axes[i]), step = s[i] - s[i - 1];
    largest_change = std::max(largest_change, turn);
    if (step > 0.0)
      largest_rate = std::max(largest_rate, turn / step);
  }
  result.largest_deviation = largest_deviation;
  result.deviating_points = deviating;
  result.largest_change = largest_change;
  result.largest_rate = largest_rate;
}

} // namespace

SmoothAxes
smoothAxes(const Polyline& points, const Vectors& wanted, const AxisFieldOptions& options)
{
  check(points, wanted, options);
  const std::vector<double> s = arcLengths(points);
  SmoothAxes result;
  result.axes = options.smoothing_length > 0.0 ? splineOfAxes(s, wanted, options.smoothing_length, options.max_deviation) : wanted;
  if (options.max_rate > 0.0 && points.size() > 1)
    RateLimit(s, options.max_rate).apply(result.axes);
  measure(s, wanted, options.max_deviation, result);
  return result;
}

std::size_t
movesTurningFaster(const Polyline& points, const Vectors& directions, double max_rate)
{
  if (points.size() < 2 || max_rate <= 0.0)
    return 0;
  return RateLimit(arcLengths(points), max_rate).exceeded(directions);
}

AxisLean
largestLean(const Vectors& normals, const Vectors& axes)
{
  AxisLean lean;
  double least = 2.0;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const double cosine = axes[i].dot(normals[i]); cosine < least) {
      least = cosine;
      lean = {0.0, i};
    }
  if (!axes.empty())
    lean.angle = angleBetween(axes[lean.point], normals[lean.point]);
  return lean;
}

bool
liesInSurface(const AxisLean& lean, const Vectors& normals, const Vectors& wanted)
{
  return lean.angle > flattest_lean && lean.angle > largestLean(normals, wanted).angle + 1e-6;
}

} // namespace pcl_spiral
