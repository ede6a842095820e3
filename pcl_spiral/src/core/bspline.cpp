// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/bspline_fit.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {

namespace {

/** Blossom of the cubic at (a, b, c), on the span that ends at knot \p k + 1; control points k-3 .. k. */
Eigen::Vector3d
blossom(const std::vector<double>& t, const Polyline& p, std::size_t k, double a, double b, double c)
{
  std::array<Eigen::Vector3d, 4> d{p[k - 3], p[k - 2], p[k - 1], p[k]};
  const std::array<double, 3> u{a, b, c};
  for (std::size_t level = 1; level <= 3; ++level)
    for (std::size_t j = 3; j >= level; --j) {
      const double low = t[k - 3 + j], high = t[k + 1 + j - level];
      const double f = (u[level - 1] - low) / (high - low);
      d[j] = (1.0 - f) * d[j - 1] + f * d[j];
    }
  return d[3];
}

void
checkKnots(const std::vector<double>& t, std::size_t controls)
{
  if (controls < 4 || t.size() != controls + 4)
    throw std::invalid_argument("BSplineCurve: give at least 4 control points, and 4 more knots than control points");
  for (std::size_t i = 1; i < t.size(); ++i) {
    const bool end = i <= 3 || i > controls;
    if (end ? t[i] != t[i - 1] : !(t[i] > t[i - 1]))
      throw std::invalid_argument("BSplineCurve: knots must ascend; the first four must be equal, and the last four");
  }
}

} // namespace

BSplineCurve::BSplineCurve(std::vector<double> knots, Polyline control_points)
: knots_(std::move(knots)), control_points_(std::move(control_points))
{
  checkKnots(knots_, control_points_.size());
  breaks_.assign(knots_.begin() + 3, knots_.end() - 3);
  polynomials_.reserve(breaks_.size() - 1);
  for (std::size_t k = 3; k < control_points_.size(); ++k) {
    const double u0 = knots_[k], u1 = knots_[k + 1], h = u1 - u0;
    const Eigen::Vector3d b0 = blossom(knots_, control_points_, k, u0, u0, u0);
    const Eigen::Vector3d b1 = blossom(knots_, control_points_, k, u0, u0, u1);
    const Eigen::Vector3d b2 = blossom(knots_, control_points_, k, u0, u1, u1);
    const Eigen::Vector3d b3 = blossom(knots_, control_points_, k, u1, u1, u1);
    polynomials_.push_back(
        {b0, 3.0 / h * (b1 - b0), 3.0 / (h * h) * (b0 - 2.0 * b1 + b2), 1.0 / (h * h * h) * (b3 - 3.0 * b2 + 3.0 * b1 - b0)});
  }
  stations_.assign(1, breaks_.front());
  lengths_.assign(1, 0.0);
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i)
    addLengths(i, breaks_[i], breaks_[i + 1], lengthBetween(i, breaks_[i], breaks_[i + 1]), 0);
}

std::size_t
BSplineCurve::span(double& u) const
{
  u = std::clamp(u, breaks_.front(), breaks_.back());
  const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, u);
  return static_cast<std::size_t>(above - breaks_.begin()) - 1;
}

Eigen::Vector3d
BSplineCurve::position(double u) const
{
  if (polynomials_.empty())
    return Eigen::Vector3d::Zero();
  const std::size_t i = span(u);
  const Polynomial& a = polynomials_[i];
  if (u == breaks_.back())
    return control_points_.back();
  const double t = u - breaks_[i];
  return a[0] + t * (a[1] + t * (a[2] + t * a[3]));
}

Eigen::Vector3d
BSplineCurve::derivative(double u) const
{
  if (polynomials_.empty())
    return Eigen::Vector3d::Zero();
  const std::size_t i = span(u);
  const Polynomial& a = polynomials_[i];
  const double t = u - breaks_[i];
  return a[1] + t * (2.0 * a[2] + 3.0 * t * a[3]);
}

Eigen::Vector3d
BSplineCurve::secondDerivative(double u) const
{
  if (polynomials_.empty())
    return Eigen::Vector3d::Zero();
  const std::size_t i = span(u);
  return 2.0 * polynomials_[i][2] + 6.0 * (u - breaks_[i]) * polynomials_[i][3];
}

double
BSplineCurve::lengthBetween(std::size_t span, double u0, double u1) const
{
  static constexpr std::array<double, 5> node{-0.90617984593866399, -0.53846931010568309, 0.0, 0.53846931010568309, 0.90617984593866399};
  static constexpr std::array<double, 5> weight{0.23692688505618909, 0.47862867049936647, 0.56888888888888889, 0.47862867049936647,
                                                0.23692688505618909};
  const Polynomial& a = polynomials_[span];
  const double middle = 0.5 * (u0 + u1) - breaks_[span], half = 0.5 * (u1 - u0);
  double sum = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double t = middle + half * node[i];
    sum += weight[i] * (a[1] + t * (2.0 * a[2] + 3.0 * t * a[3])).norm();
  }
  return half * sum;
}

void
BSplineCurve::addLengths(std::size_t span, double u0, double u1, double whole, int depth)
{
  constexpr int deepest = 20; // enough even at a cusp
  const double middle = 0.5 * (u0 + u1);
  const double first = lengthBetween(span, u0, middle), second = lengthBetween(span, middle, u1);
  if (std::abs(first + second - whole) > 1e-12 * whole && depth < deepest) {
    addLengths(span, u0, middle, first, depth + 1);
    addLengths(span, middle, u1, second, depth + 1);
    return;
  }
  stations_.insert(stations_.end(), {middle, u1});
  lengths_.push_back(lengths_.back() + first);
  lengths_.push_back(lengths_.back() + second);
}

double
BSplineCurve::arcLength(double u) const
{
  if (polynomials_.empty())
    return 0.0;
  const std::size_t i = span(u);
  if (u == breaks_.back())
    return length();
  const auto above = std::upper_bound(stations_.begin() + 1, stations_.end() - 1, u);
  const auto piece = static_cast<std::size_t>(above - stations_.begin()) - 1;
  return lengths_[piece] + lengthBetween(i, stations_[piece], u);
}

double
BSplineCurve::parameterAt(double s) const
{
  if (polynomials_.empty() || !(s > 0.0))
    return firstParameter();
  if (s >= length())
    return lastParameter();
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
  const auto piece = static_cast<std::size_t>(above - lengths_.begin()) - 1;
  const double start = stations_[piece];
  double low = start, high = stations_[piece + 1], middle = 0.5 * (low + high);
  const std::size_t i = span(middle);
  const double rest = s - lengths_[piece], whole = lengths_[piece + 1] - lengths_[piece];
  double u = low + (high - low) * (whole > 0.0 ? rest / whole : 0.0);
  for (int iteration = 0; iteration < 60; ++iteration) { // Newton; bisection if it leaves the bracket
    const double error = lengthBetween(i, start, u) - rest;
    if (std::abs(error) <= 1e-13 * length())
      break;
    (error > 0.0 ? high : low) = u;
    const double speed = derivative(u).norm();
    const double next = speed > 0.0 ? u - error / speed : low;
    u = next > low && next < high ? next : 0.5 * (low + high);
  }
  return u;
}

} // namespace pcl_spiral
