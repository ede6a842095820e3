// SPDX-License-Identifier: BSD-3-Clause
#include "support/ridges.h"

#include "support/sampling.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double degree = M_PI / 180.0;

} // namespace

Matrix3d
ExactRidge::frame(double t) const
{
  constexpr double d = 1e-4; // central differences of the fourth order
  const Vector3d m1 = (8.0 * (rail(t + d) - rail(t - d)) - (rail(t + 2.0 * d) - rail(t - 2.0 * d))).normalized();
  const Vector3d level = reference.cross(m1).normalized(), steepest = m1.cross(level);
  double low = -M_PI / 2.0, high = M_PI / 2.0; // the chord rises with its angle about the tangent
  for (int i = 0; i < 60; ++i) {
    const double psi = 0.5 * (low + high);
    const Vector3d chord = std::cos(psi) * level + std::sin(psi) * steepest;
    (std::asin(chord.dot(reference)) < theta ? low : high) = psi;
  }
  Matrix3d result;
  const Vector3d chord = std::cos(low) * level + std::sin(low) * steepest;
  result << m1, chord, m1.cross(chord);
  return result;
}

Vector3d
ExactRidge::position(double t, double w) const
{
  return rail(t) + frame(t) * generator(w);
}

Vector3d
ExactRidge::normal(double t, double w) const
{
  constexpr double d = 1e-4;
  return (position(t + d, w) - position(t - d, w)).cross(position(t, w + d) - position(t, w - d)).normalized();
}

double
ExactRidge::distance(const Vector3d& p, double& t, double& w) const
{
  constexpr double d = 1e-5;
  for (int i = 0; i < 20; ++i) {
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << (position(t + d, w) - position(t - d, w)) / (2.0 * d), (position(t, w + d) - position(t, w - d)) / (2.0 * d);
    const Eigen::Vector2d step = (jacobian.transpose() * jacobian).ldlt().solve(jacobian.transpose() * (p - position(t, w)));
    t += step.x();
    w += step.y();
    if (step.cwiseAbs().maxCoeff() < 1e-12)
      break;
  }
  return (p - position(t, w)).norm();
}

double
ExactRidge::distance(const Vector3d& p) const
{
  constexpr int along = 50, across = 4;
  double least = std::numeric_limits<double>::infinity(), t = 0.0, w = 0.0;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      const double at_t = static_cast<double>(i) / along, at_w = static_cast<double>(j) / across;
      if (const double off = (position(at_t, at_w) - p).squaredNorm(); off < least) {
        least = off;
        t = at_t;
        w = at_w;
      }
    }
  return distance(p, t, w);
}

std::vector<Vector3d>
ExactRidge::railPoints(std::size_t count) const
{
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(rail(static_cast<double>(i) / static_cast<double>(count - 1)));
  return points;
}

std::vector<Vector3d>
ExactRidge::generatorPoints(double measured_at, std::size_t count) const
{
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(position(measured_at, static_cast<double>(i) / static_cast<double>(count - 1)));
  return points;
}

ExactRidge
dieRidge()
{
  return {[](double t) { return Vector3d(600.0 * t, 60.0 * std::sin(1.6 * M_PI * t), 40.0 * std::sin(M_PI * t)); },
          [](double w) { return Vector3d(0.0, 24.0 * w, 20.0 * w * (1.0 - w) * (1.0 + (1.0 - 2.0 * w) / 2.0)); }, -15.0 * degree};
}

ExactRidge
ringRidge(double radius, std::function<Vector3d(double)> generator, double theta)
{
  return {[radius](double t) { return Vector3d(radius * std::cos(2.0 * M_PI * t), radius * std::sin(2.0 * M_PI * t), 0.0); },
          std::move(generator), theta};
}

ExactRidge
helixRidge(double radius, double slope, std::function<Vector3d(double)> generator, double theta)
{
  return {[radius, slope](double t) {
            const double angle = 2.0 * M_PI * t;
            return Vector3d(radius * std::cos(angle), radius * std::sin(angle), radius * std::tan(slope) * angle);
          },
          std::move(generator), theta};
}

std::vector<Vector3d>
moved(std::vector<Vector3d> points, double sigma, std::uint64_t seed)
{
  Random random(seed);
  for (Vector3d& p : points)
    p += sigma * Vector3d(random.normal(), random.normal(), random.normal());
  return points;
}

} // namespace pcl_spiral::test
