// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

#include <pcl_spiral/core/bspline_fit.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pcl_spiral {

SmoothLine::SmoothLine(BSplineCurve curve, double begin, double end, bool closed)
: curve_(std::move(curve)), begin_(begin), end_(end), closed_(closed)
{}

double
SmoothLine::parameterAt(double s) const
{
  if (closed_) {
    s += shift_;
    s -= length() * std::floor(s / length());
  }
  return curve_.parameterAt(begin_ + s);
}

Eigen::Vector3d
SmoothLine::position(double s) const
{
  return curve_.position(parameterAt(s));
}

Eigen::Vector3d
SmoothLine::tangent(double s) const
{
  return curve_.derivative(parameterAt(s)).normalized();
}

Eigen::Vector3d
SmoothLine::curvature(double s) const
{
  const double u = parameterAt(s);
  const Eigen::Vector3d first = curve_.derivative(u), second = curve_.secondDerivative(u);
  const double squared = first.squaredNorm();
  return (second - first * (first.dot(second) / squared)) / squared;
}

double
SmoothLine::nearest(const Eigen::Vector3d& p) const
{
  constexpr double stations_a_span = 4.0;
  const int stations = static_cast<int>(stations_a_span * static_cast<double>(curve_.spans())) + 1;
  const double step = length() / stations;
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= stations; ++k)
    if (const double d = (position(k * step) - p).squaredNorm(); d < least) {
      least = d;
      best = k * step;
    }
  double low = best - step, high = best + step;
  if (!closed_) {
    low = std::max(low, 0.0);
    high = std::min(high, length());
  }
  // The distance falls before the nearest place and rises behind it.
  for (int i = 0; i < 60 && high - low > 1e-12 * length(); ++i) {
    const double middle = 0.5 * (low + high);
    ((position(middle) - p).dot(tangent(middle)) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

SmoothLine
SmoothLine::reversed() const
{
  const double last = curve_.lastParameter();
  std::vector<double> knots;
  for (auto knot = curve_.knots().rbegin(); knot != curve_.knots().rend(); ++knot)
    knots.push_back(last - *knot);
  Polyline control(curve_.controlPoints().rbegin(), curve_.controlPoints().rend());
  SmoothLine result(BSplineCurve(std::move(knots), std::move(control)), curve_.length() - end_, curve_.length() - begin_, closed_);
  result.shift_ = -shift_;
  return result;
}

SmoothLine
SmoothLine::startingAt(double s) const
{
  SmoothLine result = *this;
  result.shift_ += s;
  return result;
}

namespace {

/** A fit by a given number of spans. */
struct Trial {
  BSplineFit fit;
  double squares = 0.0; ///< sum of the squared deviations
  double free = 0.0;    ///< points less control points
};

std::optional<Trial>
tryFit(const Polyline& points, std::size_t spans)
{
  BSplineFitOptions options;
  options.tolerance = std::numeric_limits<double>::min();
  options.min_spans = options.max_spans = spans;
  std::optional<BSplineFit> fit = fitBSpline(points, options);
  if (!fit)
    return std::nullopt;
  const auto n = static_cast<double>(points.size());
  const double squares = n * fit->rms_deviation * fit->rms_deviation;
  const double free = n - static_cast<double>(fit->curve.spans()) - 3.0;
  return Trial{std::move(*fit), squares, free};
}

/** The error along the line is not visible: it goes into the parameter, the chord length. */
double
coordinateError(const Trial& trial)
{
  return trial.free > 0.0 ? std::sqrt(trial.squares / (2.0 * trial.free)) : 0.0;
}

/** Whether the deviations of a fit are at most the given error plus a statistical allowance. */
bool
leavesError(const Trial& trial, double error)
{
  constexpr double sure = 3.0; // standard deviations of the error, from two coordinates of each point
  return coordinateError(trial) <= error * (1.0 + sure / std::sqrt(4.0 * trial.free));
}

/** Choose the fit by cross validation; or the one with fewer spans if it already reaches the given error. */
std::optional<Trial>
chooseFit(const Polyline& points, std::size_t repeated, double error)
{
  constexpr double growth = 1.3, most = 0.6; // spans a point
  constexpr double fast = 0.5;               // of the score before: without noise it falls with the eighth power of the length of the spans
  const std::size_t last = static_cast<std::size_t>(most * static_cast<double>(points.size()));
  std::optional<Trial> best, enough;
  double least = std::numeric_limits<double>::infinity(), before = least;
  bool falls = true;
  for (std::size_t spans = 1; repeated * spans <= last;
       spans = std::max(spans + 1, static_cast<std::size_t>(growth * static_cast<double>(spans)))) {
    std::optional<Trial> trial = tryFit(points, repeated * spans);
    if (!trial || !(trial->free > 0.0))
      break;
    if (error > 0.0 && !enough && leavesError(*trial, error))
      enough = trial;
    const double score = trial->squares / (trial->free * trial->free);
    falls = score < fast * before;
    before = score;
    if (score < least) {
      least = score;
      best = std::move(trial);
    }
  }
  if (enough && (!best || enough->fit.curve.spans() <= best->fit.curve.spans()))
    return enough;
  if (!best || falls) // it falls to the end, so there is no visible noise: interpolate the points
    return tryFit(points, points.size() - 3);
  return best;
}

/** The first point of \p group, moved onto a straight line fitted to the group. */
Eigen::Vector3d
endOf(const Polyline& group)
{
  const double last = static_cast<double>(group.size()) - 1.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), slope = mean;
  double squares = 0.0;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const double t = static_cast<double>(i) - 0.5 * last;
    mean += group[i] / (last + 1.0);
    slope += t * group[i];
    squares += t * t;
  }
  return mean - slope * (0.5 * last / squares);
}

/** Means of groups of \p size points; the ends of an open line do not move. */
MeasuredLine
groupMeans(const MeasuredLine& measured, std::size_t size)
{
  MeasuredLine result{{}, measured.closed, measured.spacing * static_cast<double>(size)};
  const Polyline& points = measured.points;
  const std::size_t groups = points.size() / size;
  for (std::size_t k = 0; k < groups; ++k) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(k * points.size() / groups);
    const auto end = points.begin() + static_cast<std::ptrdiff_t>((k + 1) * points.size() / groups);
    Polyline group(begin, end);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : group)
      place += p / static_cast<double>(group.size());
    if (!measured.closed && k + 1 == groups)
      std::reverse(group.begin(), group.end());
    const bool at_end = !measured.closed && (k == 0 || k + 1 == groups);
    result.points.push_back(at_end ? endOf(group) : place);
  }
  return result;
}

/** The fit to all points; for a closed line with half a round more at each end. */
LineFit
fitPoints(const MeasuredLine& measured, double error)
{
  Polyline points = measured.points;
  const std::size_t n = points.size(), half = measured.closed ? n / 2 : 0;
  if (measured.closed) {
    points.assign(measured.points.end() - static_cast<std::ptrdiff_t>(half), measured.points.end());
    points.insert(points.end(), measured.points.begin(), measured.points.end());
    points.insert(points.end(), measured.points.begin(), measured.points.begin() + static_cast<std::ptrdiff_t>(n - half + 1));
  }
  LineFit result;
  const std::optional<Trial> trial = chooseFit(points, measured.closed ? 2 : 1, error);
  if (!trial)
    return result;
  result.error = coordinateError(*trial);
  result.spans = trial->fit.curve.spans() / (measured.closed ? 2 : 1);
  const BSplineCurve& curve = trial->fit.curve;
  if (!measured.closed) {
    result.line = SmoothLine(curve, 0.0, curve.length(), false);
    return result;
  }
  double along = 0.0, round = 0.0; // chord lengths, the parameter of the curve: to the first point; once round
  for (std::size_t i = 0; i < half; ++i)
    along += (points[i + 1] - points[i]).norm();
  for (std::size_t i = half; i < half + n; ++i)
    round += (points[i + 1] - points[i]).norm();
  result.line = SmoothLine(curve, curve.arcLength(along), curve.arcLength(along + round), true);
  return result;
}

} // namespace

/** If points lie close together, errors along the line change the chord length, the parameter, and look like bends of the line. Means of
 *  several points lie farther apart and have smaller errors. */
LineFit
fitLine(const MeasuredLine& measured, double error)
{
  constexpr double apart = 30.0;    // times the error of a coordinate
  constexpr std::size_t least = 40; // points left
  const LineFit first = fitPoints(measured, error);
  if (!(measured.spacing > 0.0) || !(first.error < measured.spacing * static_cast<double>(measured.points.size())))
    return first;
  const double wanted = std::ceil(apart * first.error / measured.spacing);
  const std::size_t most = measured.points.size() / least;
  const auto size = static_cast<std::size_t>(std::min(wanted, static_cast<double>(most)));
  if (size < 2)
    return first;
  const double share = std::sqrt(static_cast<double>(size));
  LineFit result = fitPoints(groupMeans(measured, size), error / share);
  result.error *= share;
  return result.line.length() > 0.0 ? result : first;
}

double
directionError(const MeasuredLine& measured)
{
  constexpr std::size_t least_points = 16;
  constexpr int stations = 100;
  if (measured.points.size() < least_points)
    return 0.0;
  MeasuredLine halves[2];
  for (MeasuredLine& half : halves) {
    half.closed = measured.closed;
    half.spacing = 2.0 * measured.spacing;
  }
  for (std::size_t i = 0; i < measured.points.size(); ++i)
    halves[i % 2].points.push_back(measured.points[i]);
  const SmoothLine a = fitLine(halves[0]).line, b = fitLine(halves[1]).line;
  if (!(a.length() > 0.0) || !(b.length() > 0.0))
    return 0.0;
  double squares = 0.0;
  for (int k = 0; k <= stations; ++k) {
    const double s = a.length() * k / stations;
    const Eigen::Vector3d t = a.tangent(s), other = b.tangent(b.nearest(a.position(s)));
    const double angle = angleBetween(t, other) * 180.0 / pi;
    squares += angle * angle / (stations + 1);
  }
  return 0.5 * std::sqrt(squares);
}

} // namespace pcl_spiral
