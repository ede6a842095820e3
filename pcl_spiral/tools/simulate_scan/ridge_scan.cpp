// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_scan.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/ridge_frame.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

using pcl_spiral::pi;

namespace {

using Eigen::Vector3d;

constexpr double theta = -15.0 * pi / 180.0;

Vector3d
rail(double t)
{
  return {600.0 * t, 60.0 * std::sin(1.6 * pi * t), 40.0 * std::sin(pi * t)};
}

Vector3d
alongRail(double t)
{
  return {600.0, 96.0 * pi * std::cos(1.6 * pi * t), 40.0 * pi * std::cos(pi * t)};
}

/** In the frame: tangent, chord, up. */
Vector3d
generator(double w)
{
  return {0.0, 24.0 * w, 20.0 * w * (1.0 - w) * (1.5 - w)};
}

Vector3d
alongGenerator(double w)
{
  return {0.0, 24.0, 20.0 * (1.5 - 5.0 * w + 3.0 * w * w)};
}

/** The scanner's errors, added to places. */
class Sensor {
public:
  explicit Sensor(const RidgeScanSettings& settings) : settings_(settings), random_(settings.seed) {}

  double share() { return uniform_(random_); }

  pcl::PointXYZ seen(const Vector3d& place)
  {
    const double x = normal_(random_), y = normal_(random_), z = normal_(random_);
    const Eigen::Vector3f p = (place + settings_.noise * Vector3d(x, y, z)).cast<float>();
    return {p.x(), p.y(), p.z()};
  }

  /** For the full scan: a share of the points are outliers, moved along \p normal. */
  pcl::PointXYZ scanned(const Vector3d& place, const Vector3d& normal)
  {
    const bool is_outlier = share() < settings_.outliers;
    const double off = outlierDistance(share());
    return seen(is_outlier ? Vector3d(place + off * normal) : place);
  }

private:
  const RidgeScanSettings& settings_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

pcl_spiral::RidgeFrame
frameAt(double t)
{
  pcl_spiral::RidgeChord chord;
  chord.sin_angle = std::sin(theta);
  return pcl_spiral::ridgeFrame(alongRail(t).normalized(), chord).value(); // the rail is never steep
}

} // namespace

double
outlierDistance(double share)
{
  const double side = 2 * share - 1;
  return std::copysign(5 + 15 * std::abs(side), side);
}

RidgeScan
simulateRidge(const RidgeScanSettings& settings)
{
  constexpr int rail_points = 300, generator_points = 60;
  constexpr double measured_at = 0.37;
  RidgeScan result;
  Sensor sensor(settings);
  for (double t = 0.0; t <= 1.0; t += settings.line_spacing / alongRail(t).norm()) {
    const pcl_spiral::RidgeFrame frame = frameAt(t);
    double w = sensor.share() * settings.point_spacing / alongGenerator(0.0).norm(); // sensor and gantry have separate clocks
    for (; w <= 1.0; w += settings.point_spacing / alongGenerator(w).norm()) {
      const Vector3d normal = frame.turned(Vector3d::UnitX().cross(alongGenerator(w)).normalized());
      result.scan.push_back(sensor.scanned(rail(t) + frame.turned(generator(w)), normal));
    }
  }
  for (int i = 0; i < rail_points; ++i)
    result.rail.push_back(sensor.seen(rail(static_cast<double>(i) / (rail_points - 1))));
  const pcl_spiral::RidgeFrame frame = frameAt(measured_at);
  for (int i = 0; i < generator_points; ++i)
    result.generator.push_back(sensor.seen(rail(measured_at) + frame.turned(generator(static_cast<double>(i) / (generator_points - 1)))));
  return result;
}
