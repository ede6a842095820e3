// SPDX-License-Identifier: BSD-3-Clause
#include "local_fit.h"
#include "normal_equations.h"
#include "quadric.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/frame.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr int degree = 4, quadratic_terms = 6, quartic_terms = 15;
constexpr double farthest = 4.0;                 // in standard deviations: a point farther away is not part of the surface
constexpr double mad_of_normal = 1.4826;         // standard deviation over the median deviation, normal distribution
constexpr double most_noise = 1.0;               // of the quartic's height, in that of a point: beside a rim the quadric is more reliable
constexpr double most_derivative_noise = 1000.0; // of the quartic's derivatives, in the quadric's: on few scan lines

using Terms = Eigen::Matrix<double, quartic_terms, 1>; // of 1, u, v, u^2, u v, v^2, ..., v^4
using Values = Eigen::ArrayXd;                         // one per neighbour

/** How far the origin lies outside the nearer half of its neighbours, seen along the widest free angle between them: 0
 *  if no angle of more than 180 degrees is free. Sharper than overhang() on a ragged rim. */
double
outsideNearest(const Neighbourhood& near, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2)
{
  const int nearer = near.size / 2;
  Eigen::Matrix2Xd places(2, nearer);
  unsigned quadrants = 0;
  for (int j = 0; j < nearer && quadrants != 15u; ++j) {
    const Eigen::Vector3d offset(near.x[j], near.y[j], near.z[j]);
    places.col(j) = Eigen::Vector2d(offset.dot(e1), offset.dot(e2));
    if (places.col(j).isZero(0.0))
      return 0.0;
    quadrants |= 1u << ((places(0, j) < 0.0 ? 1 : 0) + (places(1, j) < 0.0 ? 2 : 0));
  }
  if (quadrants == 15u) // one in each: no free angle of more than 180 degrees
    return 0.0;
  std::vector<double> angles;
  angles.reserve(static_cast<std::size_t>(nearer));
  for (int j = 0; j < nearer; ++j)
    angles.push_back(std::atan2(places(1, j), places(0, j)));
  std::sort(angles.begin(), angles.end());
  double widest = 0.0, outward = 0.0;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double next = j + 1 < angles.size() ? angles[j + 1] : angles.front() + 2.0 * pi;
    if (next - angles[j] > widest) {
      widest = next - angles[j];
      outward = 0.5 * (next + angles[j]);
    }
  }
  if (widest <= pi)
    return 0.0;
  const Eigen::RowVector2d inward(-std::cos(outward), -std::sin(outward));
  return std::max(0.0, (inward * places).minCoeff());
}

/** Polynomials of the second and the fourth degree through weighted neighbours, coordinates over their radius. */
class LocalFit {
public:
  LocalFit(const Neighbourhood& near, double radius, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2, const Eigen::Vector3d& up)
  : powers_(near.size, 2 * degree + 1)
  {
    const auto along = [&](const Eigen::Vector3d& axis) {
      const Eigen::Vector3f a = (axis / radius).cast<float>();
      const auto n = near.size;
      using Floats = Eigen::Map<const Eigen::ArrayXf>;
      return Values((Floats(near.x, n) * a.x() + Floats(near.y, n) * a.y() + Floats(near.z, n) * a.z()).cast<double>());
    };
    u_ = along(e1);
    height_ = along(up);
    powers_.col(0).setOnes();
    powers_.col(1) = along(e2);
    for (int q = 2; q <= 2 * degree; ++q)
      powers_.col(q) = powers_.col(q - 1) * powers_.col(1);
    weight_ = (1.0 - u_.square() - powers_.col(2)).max(0.0).cube();
  }

  /** Fit both; false if not even the quadric is determined. */
  bool solve()
  {
    Eigen::Matrix<double, 2 * degree + 1, 2 * degree + 1> moment; // of u^p v^q
    Terms right;
    Values weighted = weight_;
    for (int p = 0; p <= 2 * degree; ++p, weighted *= u_) {
      for (int q = 0; q <= 2 * degree - p; ++q)
        moment(p, q) = (weighted * powers_.col(q)).sum();
      for (int q = 0; q <= degree - p; ++q)
        right[term(p, q)] = (weighted * powers_.col(q) * height_).sum();
    }
    Eigen::Matrix<double, quartic_terms, quartic_terms> normal;
    for (int p = 0; p <= degree; ++p)
      for (int q = 0; p + q <= degree; ++q)
        for (int r = 0; r <= degree; ++r)
          for (int s = 0; r + s <= degree; ++s)
            normal(term(p, q), term(r, s)) = moment(p + r, q + s);
    const NormalEquations<quartic_terms> equations(normal);
    if (equations.determined() < quadratic_terms)
      return false;
    quadratic_ = padded(equations.solve<quadratic_terms>(right.head<quadratic_terms>()));
    quartic_ = quadratic_;
    gain_ = 0.0;
    has_quartic_ = derivatives_known_ = false;
    if (equations.determined() == quartic_terms) {
      // How much the height of each neighbour changes the height at the origin.
      const Terms high = equations.solve<quartic_terms>(Terms::Unit(0));
      has_quartic_ = (weight_ * at(high)).matrix().squaredNorm() < most_noise * most_noise;
      if (has_quartic_) {
        const Terms low = padded(equations.solve<quadratic_terms>(Vector6d::Unit(0)));
        quartic_ = equations.solve<quartic_terms>(right);
        gain_ = (weight_ * at(high - low)).matrix().squaredNorm();
        derivatives_known_ = derivativesAreKnown(equations);
      }
    }
    off_ = height_ - at(quartic_);
    return true;
  }

  /** Drop the neighbours that lie too far off the fit; true if there were any. */
  bool dropOutliers(double rounding)
  {
    const Values amount = (weight_ > 0.0).select(off_.abs(), 0.0);
    const double largest = amount.maxCoeff();
    const std::ptrdiff_t kept = (weight_ > 0.0).count();
    // If half of them reach a share of the largest, so does the median, and none is too far off.
    if (largest <= farthest * rounding || 2 * (amount * (farthest * mad_of_normal) >= largest).count() > kept)
      return false;
    std::vector<double> sorted;
    for (std::ptrdiff_t j = 0; j < amount.size(); ++j)
      if (weight_[j] > 0.0)
        sorted.push_back(amount[j]);
    const auto middle = sorted.begin() + kept / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double limit = farthest * std::max(mad_of_normal * *middle, rounding);
    if (largest <= limit)
      return false;
    weight_ = (amount > limit).select(0.0, weight_);
    return true;
  }

  /** Standard deviation of the neighbours about the quartic: the weighted sum of squares over its expectation for unit
   *  noise, as in quadraticFoot; the trace is 30/7 for the fourth degree and 15/7 for the second. */
  double noise() const
  {
    const double freedom = weight_.sum() - (has_quartic_ ? 30.0 : 15.0) / 7.0;
    return freedom > 0.0 ? std::sqrt((weight_ * off_.square()).sum() / freedom) : 0.0;
  }

  /** The quadric, corrected towards the quartic as far as the square of the correction exceeds its variance: fully
   *  on a scan without noise, very little if noise hides the difference. */
  Vector6d shape() const
  {
    const double correction = quartic_[0] - quadratic_[0], sigma = noise();
    const double variance = gain_ * sigma * sigma;
    const double share = correction != 0.0 ? std::max(0.0, 1.0 - variance / (correction * correction)) : 0.0;
    Vector6d shape = (quadratic_ + share * (quartic_ - quadratic_)).head<quadratic_terms>();
    if (!derivatives_known_)
      shape.tail<5>() = quadratic_.segment<5>(1);
    return shape;
  }

private:
  /** Whether the quartic gives the first and second derivatives nearly as well as the quadric. The variance of a term for unit
   *  noise is at most its entry on the diagonal of the inverse, because the weights are below 1. */
  static bool derivativesAreKnown(const NormalEquations<quartic_terms>& equations)
  {
    for (int k = 1; k < quadratic_terms; ++k)
      if (!(equations.solve<quartic_terms>(Terms::Unit(k))[k] <
            most_derivative_noise * equations.solve<quadratic_terms>(Vector6d::Unit(k))[k]))
        return false;
    return true;
  }

  /** Index of u^p v^q among the terms. */
  static constexpr int term(int p, int q) { return (p + q) * (p + q + 1) / 2 + q; }

  static Terms padded(const Vector6d& low)
  {
    Terms terms = Terms::Zero();
    terms.head<quadratic_terms>() = low;
    return terms;
  }

  /** The polynomial at every neighbour. */
  Values at(const Terms& c) const
  {
    Values sum = Values::Zero(u_.size());
    for (int p = degree; p >= 0; --p) { // Horner's rule in u
      sum *= u_;
      for (int q = 0; p + q <= degree; ++q)
        sum += c[term(p, q)] * powers_.col(q);
    }
    return sum;
  }

  Values u_, height_, weight_, off_;
  Eigen::Array<double, Eigen::Dynamic, 2 * degree + 1> powers_; ///< of v
  Terms quadratic_, quartic_;
  bool has_quartic_ = false;
  bool derivatives_known_ = false; ///< by the quartic
  double gain_ = 0.0;              ///< variance of the correction for unit noise
};

} // namespace

SurfaceFoot
robustQuarticFoot(const Eigen::Vector3d& query, const Neighbourhood& near, const Eigen::Vector3d& up)
{
  constexpr int most_rounds = 10;
  SurfaceFoot foot;
  foot.position = query;
  foot.normal = up;
  const double radius = std::sqrt(static_cast<double>(near.squared_distance[near.size - 1]));
  Eigen::Vector3d e1, e2;
  tangentFrame(up, e1, e2);
  foot.overhang = outsideNearest(near, e1, e2);
  LocalFit fit(near, radius, e1, e2, up);
  const double rounding = 1e-7 * (query.cwiseAbs().maxCoeff() / radius + 1.0); // of single precision
  for (int round = 0;; ++round) {
    if (!fit.solve())
      return foot;
    if (round == most_rounds || !fit.dropOutliers(rounding))
      break;
  }
  if (!standOnQuadric(fit.shape(), radius, e1, e2, up, foot))
    return foot;
  foot.residual = radius * fit.noise();
  foot.valid = true;
  return foot;
}

} // namespace pcl_spiral
