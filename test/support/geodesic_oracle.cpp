// SPDX-License-Identifier: BSD-3-Clause
#include "support/geodesic_oracle.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {
namespace {

using Eigen::Vector3d;

constexpr int steps = 4000;

struct State {
  Vector3d x, v;
};

Vector3d
acceleration(const AnalyticSurface& surface, const State& s)
{
  const Vector3d g = surface.gradient(s.x);
  return -s.v.dot(surface.hessian(s.x) * s.v) / g.squaredNorm() * g;
}

/** Fourth-order Runge-Kutta over \p length. */
Polyline
shoot(const AnalyticSurface& surface, const Vector3d& from, const Vector3d& direction, double length, State& end)
{
  State s{from, direction};
  const double h = length / steps;
  Polyline line{from};
  for (int k = 0; k < steps; ++k) {
    const State s1 = s;
    const Vector3d a1 = acceleration(surface, s1);
    const State s2{s.x + 0.5 * h * s1.v, s.v + 0.5 * h * a1};
    const Vector3d a2 = acceleration(surface, s2);
    const State s3{s.x + 0.5 * h * s2.v, s.v + 0.5 * h * a2};
    const Vector3d a3 = acceleration(surface, s3);
    const State s4{s.x + h * s3.v, s.v + h * a3};
    const Vector3d a4 = acceleration(surface, s4);
    s.x += h / 6.0 * (s1.v + 2.0 * s2.v + 2.0 * s3.v + s4.v);
    s.v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    line.push_back(s.x);
  }
  end = s;
  return line;
}

} // namespace

ExactGeodesic
exactGeodesic(const AnalyticSurface& surface, const Vector3d& from, const Vector3d& to, const Vector3d& towards, double length_guess)
{
  const Vector3d normal = surface.normal(from);
  const Vector3d e1 = (towards - normal * normal.dot(towards)).normalized(), e2 = normal.cross(e1);
  const auto heading = [&](double angle) { return Vector3d(std::cos(angle) * e1 + std::sin(angle) * e2); };
  double angle = 0.0, reach = length_guess;
  ExactGeodesic best;
  best.miss = 1e9;
  for (int k = 0; k < 20 && best.miss > 1e-8; ++k) {
    State end, turned;
    const Polyline line = shoot(surface, from, heading(angle), reach, end);
    const Vector3d miss = to - end.x;
    if (miss.norm() < best.miss)
      best = {line, reach, miss.norm()};
    constexpr double tilt = 1e-6;
    shoot(surface, from, heading(angle + tilt), reach, turned);
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << (turned.x - end.x) / tilt, end.v;
    const Eigen::Vector2d change = jacobian.colPivHouseholderQr().solve(miss);
    angle += change[0];
    reach += change[1];
  }
  return best;
}

double
sidewaysDistance(const AnalyticSurface& surface, const Polyline& line, const Polyline& curve)
{
  double largest = 0.0;
  std::size_t j = 0;
  for (const Vector3d& p : line) {
    while (j + 2 < curve.size() && (curve[j + 1] - p).squaredNorm() < (curve[j] - p).squaredNorm())
      ++j;
    double nearest = 1e300;
    for (std::size_t i = j > 2 ? j - 2 : 0; i < std::min(j + 2, curve.size() - 1); ++i) {
      const Vector3d along = curve[i + 1] - curve[i];
      const double f = std::clamp((p - curve[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      Vector3d off = p - curve[i] - f * along;
      const Vector3d n = surface.normal(curve[i]);
      off -= n * n.dot(off);
      nearest = std::min(nearest, off.norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

Vector3d
onSpheroid(double a, double b, double latitude, double longitude)
{
  const double lat = latitude * M_PI / 180.0, lon = longitude * M_PI / 180.0, e2 = 1.0 - b * b / (a * a);
  const double n = a / std::sqrt(1.0 - e2 * std::sin(lat) * std::sin(lat));
  return {n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon), n * (1.0 - e2) * std::sin(lat)};
}

} // namespace pcl_spiral::test
