#include "local_fit.h"
#include "quadric.h"

#include <pcl_spiral/core/frame.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr int quadratic_terms = 6, quartic_terms = 15;
constexpr double farthest = 4.0; // in standard deviations: a point farther off is no part of the surface
constexpr double mad_of_normal = 1.4826; // standard deviation over the median deviation, normal distribution

using Terms = Eigen::Matrix<double, quartic_terms, 1>;
using TermRows = Eigen::Matrix<double, quartic_terms, Eigen::Dynamic>;
using NormalMatrix = Eigen::Matrix<double, quartic_terms, quartic_terms>;

/** 1, u, v, u^2, u v, v^2, ..., v^4. */
Terms
termsAt(double u, double v)
{
  Terms t;
  int k = 0;
  for (int degree = 0; degree <= 4; ++degree)
    for (int j = 0; j <= degree; ++j, ++k)
      t[k] = j == 0 ? (degree == 0 ? 1.0 : t[k - degree] * u) : t[k - degree - 1] * v;
  return t;
}

/** How far the origin lies outside the nearer half of its neighbours, seen along the widest free angle between them: 0
 *  where no angle of more than 180 degrees is free. Sharper than overhang() on a ragged rim. */
double
outsideNearest(const Neighbourhood& near, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2)
{
  const int nearer = near.size / 2;
  Eigen::Matrix2Xd places(2, nearer);
  std::vector<double> angles;
  for (int j = 0; j < nearer; ++j) {
    const Eigen::Vector3d offset(near.x[j], near.y[j], near.z[j]);
    places.col(j) = Eigen::Vector2d(offset.dot(e1), offset.dot(e2));
    if (places.col(j).isZero(0.0))
      return 0.0;
    angles.push_back(std::atan2(places(1, j), places(0, j)));
  }
  std::sort(angles.begin(), angles.end());
  double widest = 0.0, outward = 0.0;
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const double next = j + 1 < angles.size() ? angles[j + 1] : angles.front() + 2.0 * M_PI;
    if (next - angles[j] > widest) {
      widest = next - angles[j];
      outward = 0.5 * (next + angles[j]);
    }
  }
  if (widest <= M_PI)
    return 0.0;
  const Eigen::RowVector2d inward(-std::cos(outward), -std::sin(outward));
  return std::max(0.0, (inward * places).minCoeff());
}

/** Polynomials of the second and the fourth degree through weighted neighbours, coordinates over their radius. */
class LocalFit {
public:
  LocalFit(const Neighbourhood& near, double radius, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2,
           const Eigen::Vector3d& up)
  : terms_(quartic_terms, near.size), height_(near.size), weight_(near.size)
  {
    for (int j = 0; j < near.size; ++j) {
      const Eigen::Vector3d offset = Eigen::Vector3d(near.x[j], near.y[j], near.z[j]) / radius;
      const double u = offset.dot(e1), v = offset.dot(e2), inside = std::max(0.0, 1.0 - (u * u + v * v));
      terms_.col(j) = termsAt(u, v);
      height_[j] = offset.dot(up);
      weight_[j] = inside * inside * inside;
    }
  }

  /** Fit both; false where not even the quadric is determined. */
  bool
  solve()
  {
    const TermRows weighted = terms_ * weight_.asDiagonal();
    normal_.noalias() = weighted * terms_.transpose();
    right_.noalias() = weighted * height_;
    const Eigen::LLT<Eigen::Matrix<double, quadratic_terms, quadratic_terms>> low(
        normal_.topLeftCorner<quadratic_terms, quadratic_terms>());
    if (!determined(low))
      return false;
    quadratic_.setZero();
    quadratic_.head<quadratic_terms>() = low.solve(right_.head<quadratic_terms>());
    const Eigen::LLT<NormalMatrix> high(normal_);
    has_quartic_ = determined(high) && (weighted.transpose() * high.solve(Terms::Unit(0))).squaredNorm() < 1.0;
    quartic_ = has_quartic_ ? Terms(high.solve(right_)) : quadratic_;
    // How much each neighbour's height moves the quartic's height at the origin more than the quadric's.
    Terms influence = Terms::Zero();
    influence.head<quadratic_terms>() = -low.solve(Vector6d::Unit(0));
    if (has_quartic_)
      influence += high.solve(Terms::Unit(0));
    gain_ = has_quartic_ ? (weighted.transpose() * influence).squaredNorm() : 0.0;
    return true;
  }

  /** Drop the neighbours that lie too far off the fit; true where there are any. */
  bool
  dropOutliers(double rounding)
  {
    const Eigen::VectorXd off = (height_ - terms_.transpose() * quartic_).cwiseAbs();
    std::vector<double> kept;
    for (int j = 0; j < off.size(); ++j)
      if (weight_[j] > 0.0)
        kept.push_back(off[j]);
    const auto middle = kept.begin() + static_cast<std::ptrdiff_t>(kept.size() / 2);
    std::nth_element(kept.begin(), middle, kept.end());
    const double limit = farthest * std::max(mad_of_normal * *middle, rounding);
    bool any = false;
    for (int j = 0; j < off.size(); ++j)
      if (weight_[j] > 0.0 && off[j] > limit) {
        weight_[j] = 0.0;
        any = true;
      }
    return any;
  }

  /** Standard deviation of the neighbours about the quartic: the weighted sum of squares over its expectation for unit
   *  noise, as in quadraticFoot; the trace is 30/7 for the fourth degree and 15/7 for the second. */
  double
  scatter() const
  {
    const double squares = (weight_.array() * (height_ - terms_.transpose() * quartic_).array().square()).sum();
    const double freedom = weight_.sum() - (has_quartic_ ? 30.0 : 15.0) / 7.0;
    return freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0;
  }

  /** The quadric, corrected towards the quartic by as much as the correction's square stands out of its variance: all
   *  the way on a scan without noise, hardly where noise hides the difference. */
  Vector6d
  shape() const
  {
    const double correction = quartic_[0] - quadratic_[0], noise = scatter();
    const double variance = gain_ * noise * noise;
    const double share = correction != 0.0 ? std::max(0.0, 1.0 - variance / (correction * correction)) : 0.0;
    return (quadratic_ + share * (quartic_ - quadratic_)).head<quadratic_terms>();
  }

private:
  template <typename Factor>
  static bool
  determined(const Factor& factor)
  {
    if (factor.info() != Eigen::Success)
      return false;
    const auto diagonal = factor.matrixLLT().diagonal();
    return diagonal.minCoeff() > 1e-3 * diagonal.maxCoeff(); // squared: the pivots' ratio
  }

  TermRows terms_;
  Eigen::VectorXd height_, weight_;
  NormalMatrix normal_;
  Terms right_, quadratic_, quartic_;
  bool has_quartic_ = false;
  double gain_ = 0.0; ///< variance of the correction for unit noise
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
  foot.residual = radius * fit.scatter();
  foot.valid = true;
  return foot;
}

} // namespace pcl_spiral
