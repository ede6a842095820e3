// SPDX-License-Identifier: BSD-3-Clause
#include "rim_band.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double ray_step = 0.5;     // spacings between rays along the outline
constexpr double fan_step = 0.2;     // radians between rays
constexpr double first_row = 0.7;    // spacings from the outline
constexpr double least_share = 0.98; // of the given distance: points nearer to the outline are dropped
constexpr double least_apart = 0.6;  // spacings between points of the band

double
distanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double share = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (a + share * d - p).norm();
}

} // namespace

RimBand::RimBand(const Surface& surface, const Polyline& curve) : spacing_(surface.spacing())
{
  curve_ = resampled(curve, static_cast<std::size_t>(std::ceil(length(curve, true) / (ray_step * spacing_))), true);
  std::vector<SurfaceFoot> feet;
  surface.fit().project(curve_, feet);
  const std::size_t n = curve_.size();
  std::vector<Ray> rays(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d normal = feet[i].valid ? feet[i].normal : surface.normal(surface.graph().blocks().nearest(curve_[i]));
    const Eigen::Vector3d along = curve_[(i + 2) % n] - curve_[(i + n - 2) % n];
    rays[i] = {curve_[i], along.cross(normal).normalized()}; // the surface lies on the left
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Ray &ray = rays[i], &next = rays[(i + 1) % n];
    const double turn = std::acos(std::clamp(ray.along.dot(next.along), -1.0, 1.0));
    const int parts = std::max(1, static_cast<int>(std::ceil(turn / fan_step)));
    for (int k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      const Eigen::Vector3d along = (1.0 - share) * ray.along + share * next.along;
      if (along.norm() > 1e-6)
        rays_.push_back({(1.0 - share) * ray.from + share * next.from, along.normalized()});
    }
  }
}

double
RimBand::distanceTo(const Eigen::Vector3d& place) const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve_.size(); ++i)
    least = std::min(least, distanceToSegment(place, curve_[i], curve_[(i + 1) % curve_.size()]));
  return least;
}

Polyline
RimBand::line(double distance, double step) const
{
  Polyline tips;
  for (const Ray& ray : rays_)
    tips.push_back(ray.from + distance * ray.along);
  const Polyline even = resampled(tips, static_cast<std::size_t>(std::ceil(length(tips, true) / step)), true);
  std::vector<std::uint8_t> kept(even.size());
  const auto count = static_cast<std::int64_t>(even.size());
#pragma omp parallel for schedule(static, 64)
  for (std::int64_t i = 0; i < count; ++i)
    kept[i] = distanceTo(even[i]) >= least_share * distance;
  Polyline line;
  for (std::size_t i = 0; i < even.size(); ++i)
    if (kept[i])
      line.push_back(even[i]);
  return line;
}

std::vector<Eigen::Vector3f>
RimBand::points(double distance) const
{
  std::vector<Eigen::Vector3f> band;
  Polyline before;
  for (double out = first_row * spacing_; out < distance; out += spacing_) {
    Polyline row = line(out, spacing_);
    for (std::size_t i = 0; i < row.size(); ++i) {
      bool close = i > 0 && (row[i] - row[i - 1]).norm() < least_apart * spacing_;
      for (const Eigen::Vector3d& p : before)
        close = close || (p - row[i]).norm() < least_apart * spacing_;
      if (!close)
        band.push_back(row[i].cast<float>());
    }
    before = std::move(row);
  }
  return band;
}

} // namespace pcl_spiral
