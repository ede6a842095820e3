// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_axes.h"

#include "axis_smoothing.h"

#include <pcl_spiral/core/impl/angles.h>

#include "core/angle_between.h"

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

/** \p from turned by \p angle towards \p to. */
Vector3d
turnedTowards(const Vector3d& from, const Vector3d& to, double angle)
{
  Vector3d side = to - from.dot(to) * from;
  side = side.norm() > 1e-12 ? Vector3d(side.normalized()) : Vector3d(from.unitOrthogonal()); // opposite: in any direction
  return (std::cos(angle) * from + std::sin(angle) * side).normalized();
}

/** Limits the turn on every move to a rate times its length. */
class RateLimit {
public:
  /** \p s: arc lengths, which must live as long as this. */
  RateLimit(const std::vector<double>& s, double max_rate) : s_(s), max_rate_(max_rate) {}

  /** Moves on which the turn is above the limit. */
  std::size_t exceeded(const Vectors& axes) const
  {
    std::size_t count = 0;
    const auto moves = static_cast<std::int64_t>(s_.size()) - 1;
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
  double limit(std::size_t move) const
  {
    return std::min(pi, max_rate_ * (s_[move + 1] - s_[move]));
  }

  /** Compares chords of the unit circle: 2 sin(x) at half the limit, which is at least 2 (x - x^3 / 6). Most turns are below that. */
  bool exceeds(std::size_t move, const Vector3d& a, const Vector3d& b) const
  {
    const double x = 0.5 * limit(move), turn = (b - a).squaredNorm(), least = 2.0 * x * (1.0 - x * x / 6.0);
    if (turn < least * least)
      return false;
    const double chord = 2.0 * std::sin(x * (1.0 + rounding));
    return turn > chord * chord + 1e-24;
  }

  void forward(Vectors& axes) const
  {
    for (std::size_t i = 1; i < axes.size(); ++i)
      if (exceeds(i - 1, axes[i - 1], axes[i]))
        axes[i] = turnedTowards(axes[i - 1], axes[i], limit(i - 1));
  }

  void backward(Vectors& axes) const
  {
    for (std::size_t i = axes.size() - 1; i-- > 0;)
      if (exceeds(i, axes[i], axes[i + 1]))
        axes[i] = turnedTowards(axes[i + 1], axes[i], limit(i));
  }

  const std::vector<double>& s_;
  double max_rate_;
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

/** The square of the chord of \p angle on the unit circle. */
double
squaredChord(double angle)
{
  const double half = std::sin(0.5 * std::min(angle, pi));
  return 4.0 * half * half;
}

/** The largest values at a block of points. Angles are compared by their chords, and computed only where they may be larger. */
struct LargestAngles {
  double deviation = 0.0, change = 0.0, rate = 0.0;
  std::size_t deviating = 0;

  LargestAngles(const std::vector<double>& s, const Vectors& wanted, const Vectors& axes, std::size_t begin, std::size_t end,
                double allowed_chord)
  {
    double deviation_chord = 0.0, change_chord = 0.0;
    const auto take = [](const Vector3d& a, const Vector3d& b, double chord, double& largest_chord, double& largest) {
      if (chord * (1.0 + rounding) < largest_chord)
        return;
      largest_chord = std::max(largest_chord, chord);
      largest = std::max(largest, angleBetween(a, b));
    };
    for (std::size_t i = begin; i < end; ++i) {
      const double deviating_chord = (axes[i] - wanted[i]).squaredNorm();
      take(axes[i], wanted[i], deviating_chord, deviation_chord, deviation);
      deviating += deviating_chord > allowed_chord;
      if (i == 0)
        continue;
      const double chord = (axes[i] - axes[i - 1]).squaredNorm(), step = s[i] - s[i - 1];
      take(axes[i - 1], axes[i], chord, change_chord, change);
      const double most = 1.0 + 0.15 * chord, fast = rate * step; // no angle is more than so many times its chord
      if (step > 0.0 && chord * most * most > fast * fast)
        rate = std::max(rate, angleBetween(axes[i - 1], axes[i]) / step);
    }
  }
};

void
measure(const std::vector<double>& s, const Vectors& wanted, double max_deviation, SmoothAxes& result)
{
  constexpr std::size_t together = 4096; // points; the same for any number of threads
  const Vectors& axes = result.axes;
  const auto blocks = static_cast<std::int64_t>((axes.size() + together - 1) / together);
  const double allowed_chord = max_deviation < pi ? squaredChord(max_deviation) : 5.0; // more than any
  double largest_deviation = 0.0, largest_change = 0.0, largest_rate = 0.0;
  std::size_t deviating = 0;
#pragma omp parallel for schedule(static) reduction(max : largest_deviation, largest_change, largest_rate) reduction(+ : deviating)
  for (std::int64_t block = 0; block < blocks; ++block) {
    const std::size_t begin = block * together;
    const LargestAngles of(s, wanted, axes, begin, std::min(axes.size(), begin + together), allowed_chord);
    largest_deviation = std::max(largest_deviation, of.deviation);
    largest_change = std::max(largest_change, of.change);
    largest_rate = std::max(largest_rate, of.rate);
    deviating += of.deviating;
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
  if (!s.empty() && !std::isfinite(s.back()))
    throw std::invalid_argument("smoothAxes: a point is not finite");
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
  const std::vector<double> s = arcLengths(points);
  return RateLimit(s, max_rate).exceeded(directions);
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
