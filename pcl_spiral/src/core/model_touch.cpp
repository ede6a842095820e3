// SPDX-License-Identifier: BSD-3-Clause
#include "model_touch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Tangent t of the angle at which R2 + r sin + c tan = q, by Newton's method from below: the function is
 * concave. */
double
cornerTangent(double past_flat, double r, double c)
{
  double t = std::max(past_flat / (r + c), (past_flat - r) / c);
  for (int i = 0; i < 60; ++i) {
    const double root = std::sqrt(1.0 + t * t);
    const double step = (past_flat - r * t / root - c * t) / (r / (root * root * root) + c);
    t += step;
    if (!(step > 1e-15 * t))
      break;
  }
  return t;
}

/** x - prox(x + c grad), and its derivative. */
struct Residual {
  Residual(const CutterProfile& profile, const HeightModel& model, double c, const Eigen::Vector2d& x)
  {
    const Eigen::Vector2d y = x + c * (model.slope + model.bend * (x - model.at));
    const double q = y.norm();
    double derivative = 0.0;
    const double p = proximalRadius(profile, q, c, derivative);
    Eigen::Matrix2d turn = derivative * Eigen::Matrix2d::Identity();
    moved.setZero();
    if (q > 0.0) {
      const Eigen::Vector2d u = y / q;
      moved = p * u;
      turn = p / q * Eigen::Matrix2d::Identity() + (derivative - p / q) * u * u.transpose();
    }
    value = x - moved;
    slope = Eigen::Matrix2d::Identity() - turn * (Eigen::Matrix2d::Identity() + c * model.bend);
  }
  Eigen::Vector2d value, moved;
  Eigen::Matrix2d slope;
};

} // namespace

double
proximalRadius(const CutterProfile& profile, double q, double c, double& derivative)
{
  derivative = 1.0;
  if (q <= profile.flatRadius())
    return q;
  const double tangent = std::tan(profile.flankAngle()), R1 = profile.flankRadius();
  if (tangent == 0.0 || q < R1 + c / tangent) {
    const double r = profile.cornerRadius(), t = cornerTangent(q - profile.flatRadius(), r, c);
    const double root = std::sqrt(1.0 + t * t), curve = r / (root * root * root);
    derivative = curve / (curve + c);
    return std::min(R1, profile.flatRadius() + r * t / root);
  }
  if (q <= profile.radius() + c / tangent)
    return q - c / tangent;
  derivative = 0.0;
  return profile.radius();
}

Eigen::Vector2d
touchModel(const CutterProfile& profile, const HeightModel& model)
{
  const double R = profile.radius(), c = 1.0 / (model.bend.norm() + 1.0 / R);
  constexpr int most_steps = 100;
  Eigen::Vector2d x = model.at;
  Residual here(profile, model, c, x);
  for (int i = 0; i < most_steps && here.value.norm() > 1e-13 * R; ++i) {
    if (std::abs(here.slope.determinant()) > 1e-12) {
      const Eigen::Vector2d newton = x - here.slope.inverse() * here.value;
      if (newton.allFinite()) {
        const Residual there(profile, model, c, newton);
        if (there.value.norm() < 0.5 * here.value.norm()) {
          x = newton;
          here = there;
          continue;
        }
      }
    }
    x = here.moved;
    here = Residual(profile, model, c, x);
  }
  return here.moved;
}

} // namespace pcl_spiral
