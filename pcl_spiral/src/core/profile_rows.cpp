// SPDX-License-Identifier: BSD-3-Clause
#include "profile_rows.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int near_angles = 24, far_angles = 24;
constexpr double smallest_angle = 1e-7;

/** Angles from the contact to one side: dense where the cutter stands lower than \p height above the plane, then evenly to 90 degrees. */
std::vector<double>
anglesOf(double corner, double height)
{
  const double dense = std::min(0.25 * pi, 2.0 * std::sqrt(2.0 * height / std::max(corner, height)));
  std::vector<double> angles{smallest_angle};
  for (int k = 1; k <= near_angles; ++k)
    angles.push_back(dense * k / near_angles);
  for (int k = 1; k < far_angles; ++k)
    angles.push_back(dense + (0.5 * pi - dense) * k / far_angles);
  return angles;
}

} // namespace

PassSection::PassSection(const CutterProfile& profile, const Vector3d& axis, const Vector3d& normal, const Vector3d& travel, double height)
{
  const Vector3d w = travel.cross(normal), zero = Vector3d::Zero();
  const auto touched = [&](double angle) { return profile.locate(zero, std::cos(angle) * normal + std::sin(angle) * w, axis); };
  const CutterContact middle = touched(0.0);
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? 1.0 : -1.0; // the cutter touches a plane that falls to the other side further on this side
    sides_[k].emplace_back(0.0, 0.0);
    for (const double angle : anglesOf(profile.cornerRadius(), height)) {
      const CutterContact contact = touched(-side * angle);
      if (!contact.touches)
        break;
      const Vector3d away = middle.tip - contact.tip;
      const Vector2d at(side * away.dot(w), std::max(0.0, away.dot(normal)));
      if (at.x() > sides_[k].back().x())
        sides_[k].push_back(at);
    }
    if (const double rise = side * axis.dot(w); rise > 0.0) // the shank
      sides_[k].push_back(sides_[k].back() + 2.0 * profile.radius() * Vector2d(rise, axis.dot(normal)));
  }
}

double
PassSection::reach(double height, double curvature, int side) const
{
  const std::vector<Vector2d>& places = sides_[side > 0 ? 0 : 1];
  const auto above = [&](const Vector2d& p) { return p.y() + 0.5 * curvature * p.x() * p.x() - height; };
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (above(places[i]) < 0.0)
      continue;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      (above(places[i - 1] + middle * (places[i] - places[i - 1])) < 0.0 ? low : high) = middle;
    }
    return (places[i - 1] + low * (places[i] - places[i - 1])).x();
  }
  return places.back().x();
}

double
profileRowDistance(const SurfaceBend& place, const Vector3d& across, const CutterProfile& profile, const Vector3d& axis, double height,
                   RowsThrough through, double flattest)
{
  const Vector3d along = place.normal.cross(across);
  const double lean = along.norm();
  if (!(lean > 0.0))
    return 0.0;
  const Vector3d t = along / lean, w = t.cross(place.normal);
  const double c = w.dot(place.direction1), s = w.dot(place.normal.cross(place.direction1));
  const double bend = place.curvature1 * c * c + place.curvature2 * s * s, corner = profile.cornerRadius();
  if (bend >= -flattest || profile.flatRadius() <= 0.0)
    return PassSection(profile, axis, place.normal, t, height).width(height, std::max(0.0, bend)) * lean;
  const CutterShape edge = CutterShape::ball(std::max(corner, height));
  const double nearer = through == RowsThrough::Centres ? std::max(0.0, 1.0 + corner * bend) : 1.0;
  return PassSection(CutterProfile(edge), axis, place.normal, t, height).width(height) * nearer * lean;
}

} // namespace pcl_spiral
