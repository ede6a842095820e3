// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/bspline_fit.h>

#include "band_system.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {

namespace {

/** The four cubic basis functions that differ from zero at \p u in [t_k, t_{k+1}] (Piegl and Tiller 1997,
 * A2.2). */
std::array<double, 4>
basis(const std::vector<double>& t, std::size_t k, double u)
{
  std::array<double, 4> n{1.0, 0.0, 0.0, 0.0}, left{}, right{};
  for (std::size_t j = 1; j <= 3; ++j) {
    left[j] = u - t[k + 1 - j];
    right[j] = t[k + j] - u;
    double saved = 0.0;
    for (std::size_t r = 0; r < j; ++r) {
      const double f = n[r] / (right[r + 1] + left[j - r]);
      n[r] = saved + right[r + 1] * f;
      saved = left[j - r] * f;
    }
    n[j] = saved;
  }
  return n;
}

/** Knots at equal lengths. */
std::vector<double>
equalKnots(double end, std::size_t spans)
{
  std::vector<double> t(4, 0.0);
  for (std::size_t j = 1; j < spans; ++j)
    t.push_back(end * static_cast<double>(j) / static_cast<double>(spans));
  t.insert(t.end(), 4, end);
  return t;
}

/** Knots at equal shares of the points (Piegl and Tiller 1997, equation 9.69). */
std::vector<double>
sharedKnots(const std::vector<double>& u, std::size_t spans)
{
  std::vector<double> t(4, 0.0);
  const double share = static_cast<double>(u.size()) / static_cast<double>(spans);
  for (std::size_t j = 1; j < spans; ++j) {
    const double at = static_cast<double>(j) * share;
    const auto i = static_cast<std::size_t>(at);
    const double f = at - static_cast<double>(i);
    t.push_back((1.0 - f) * u[i - 1] + f * u[i]);
  }
  t.insert(t.end(), 4, u.back());
  return t;
}

/** Knots for one control point a point: means of three parameters (Piegl and Tiller 1997, equation 9.8). */
std::vector<double>
averagedKnots(const std::vector<double>& u)
{
  std::vector<double> t(4, 0.0);
  for (std::size_t j = 1; j + 3 < u.size(); ++j)
    t.push_back((u[j] + u[j + 1] + u[j + 2]) / 3.0);
  t.insert(t.end(), 4, u.back());
  return t;
}

/** Whether every span holds a point inside, or on its start. */
bool
everySpanHolds(const std::vector<double>& t, const std::vector<double>& u)
{
  std::size_t i = 1;
  for (std::size_t k = 3; k + 4 < t.size(); ++k) {
    while (i + 1 < u.size() && u[i] < t[k])
      ++i;
    if (i + 1 >= u.size() || u[i] >= t[k + 1])
      return false;
  }
  return true;
}

/** Least-squares curve over given knots, before it is made a curve. */
struct Trial {
  std::vector<double> knots;
  Polyline control; ///< empty when the system is singular
  double max_deviation = 0.0;
  double rms_deviation = 0.0;
};

Trial
leastSquares(std::vector<double> t, const std::vector<double>& u, const Polyline& points)
{
  const std::size_t controls = t.size() - 4, last = controls - 1, n = points.size();
  std::vector<std::size_t> first(n, 0); // control point of the first basis function at each point
  std::vector<std::array<double, 4>> weights(n);
  BandSystem system(controls - 2, 3, false); // the ends are known: control 1 is row 0
  Polyline inner(controls - 2, Eigen::Vector3d::Zero());
  for (std::size_t i = 1, k = 3; i + 1 < n; ++i) {
    while (k < last && u[i] >= t[k + 1])
      ++k;
    first[i] = k - 3;
    weights[i] = basis(t, k, u[i]);
    Eigen::Vector3d rest = points[i];
    if (first[i] == 0)
      rest -= weights[i][0] * points.front();
    if (k == last)
      rest -= weights[i][3] * points.back();
    for (std::size_t a = 0; a < 4; ++a) {
      const std::size_t c = first[i] + a;
      if (c == 0 || c == last)
        continue;
      inner[c - 1] += weights[i][a] * rest;
      for (std::size_t b = first[i] == 0 ? 1 : 0; b <= a; ++b)
        system.add(c - 1, c - 1 - (a - b), weights[i][a] * weights[i][b]);
    }
  }
  Trial trial;
  if (!system.solveIfIndependent(inner, 1e-8))
    return trial;
  trial.control.push_back(points.front());
  trial.control.insert(trial.control.end(), inner.begin(), inner.end());
  trial.control.push_back(points.back());
  trial.knots = std::move(t);
  double sum = 0.0, worst = 0.0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    Eigen::Vector3d error = -points[i];
    for (std::size_t a = 0; a < 4; ++a)
      error += weights[i][a] * trial.control[first[i] + a];
    sum += error.squaredNorm();
    worst = std::max(worst, error.squaredNorm());
  }
  trial.max_deviation = std::sqrt(worst);
  trial.rms_deviation = std::sqrt(sum / static_cast<double>(n));
  return trial;
}

/** Line or parabola through two or three points, as a cubic. */
BSplineFit
lowDegree(const std::vector<double>& u, const Polyline& p)
{
  const double end = u.back();
  Eigen::Vector3d middle = 0.5 * (p.front() + p.back()); // Bezier point of the parabola
  if (p.size() == 3) {
    const double f = u[1] / end;
    middle = (p[1] - (1 - f) * (1 - f) * p[0] - f * f * p[2]) / (2.0 * f * (1 - f));
  }
  BSplineFit fit;
  fit.curve = BSplineCurve(equalKnots(end, 1), {p.front(), (p.front() + 2.0 * middle) / 3.0, (p.back() + 2.0 * middle) / 3.0, p.back()});
  fit.within_tolerance = true;
  return fit;
}

/** The knots for \p spans spans that keep the system well conditioned. */
std::vector<double>
chooseKnots(const std::vector<double>& u, std::size_t spans)
{
  if (spans + 3 >= u.size())
    return averagedKnots(u);
  std::vector<double> knots = equalKnots(u.back(), spans);
  if (2 * spans > u.size() || !everySpanHolds(knots, u))
    knots = sharedKnots(u, spans);
  return knots;
}

} // namespace

std::optional<BSplineFit>
fitBSpline(const Polyline& points, const BSplineFitOptions& options)
{
  Polyline distinct;
  for (const Eigen::Vector3d& p : points) {
    if (!p.allFinite())
      return std::nullopt;
    if (distinct.empty() || p != distinct.back())
      distinct.push_back(p);
  }
  if (distinct.size() < 2 || !(options.tolerance > 0.0))
    return std::nullopt;
  const std::vector<double> u = arcLengths(distinct);
  if (distinct.size() < 4)
    return lowDegree(u, distinct);
  const std::size_t most = distinct.size() - 3;
  const std::size_t limit = options.max_spans ? std::min(options.max_spans, most) : most;
  std::size_t spans = std::clamp<std::size_t>(options.min_spans, 1, limit);
  Trial best;
  for (;;) {
    Trial trial = leastSquares(chooseKnots(u, spans), u, distinct);
    if (!trial.control.empty() && (best.control.empty() || trial.max_deviation < best.max_deviation))
      best = std::move(trial);
    if (spans == limit || (!best.control.empty() && best.max_deviation <= options.tolerance))
      break;
    spans = 4 * spans > distinct.size() ? limit : 2 * spans;
    spans = std::min(spans, limit);
  }
  if (best.control.empty())
    return std::nullopt;
  return BSplineFit{BSplineCurve(std::move(best.knots), std::move(best.control)), best.max_deviation, best.rms_deviation,
                    best.max_deviation <= options.tolerance};
}

} // namespace pcl_spiral
