// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

// Twice the projected area over squared length:
constexpr double sliver = 1e-12; // below this only the edges count
constexpr double thin = 1e-6;    // below this all edges are checked, because of rounding
constexpr double full = 1e-3;    // above this, and not steep, the plane is accurate enough
constexpr double steep = 100.0;

double
cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** Half the length of the chord that a circle cuts out of a line at the distance \p p from its centre. */
double
halfChord(double radius, double p)
{
  return std::sqrt(std::max(0.0, (radius - p) * (radius + p)));
}

} // namespace

TriangleTouch::TriangleTouch(const CutterProfile& profile)
: profile_(profile), cos_angle_(std::cos(profile.flankAngle())),
  steepest_(profile.flankAngle() > 0.0 ? 1.0 / std::tan(profile.flankAngle()) : std::numeric_limits<double>::infinity())
{}

double
TriangleTouch::heightAt(double l, double wider) const
{
  return profile_.height(std::clamp(l - wider, 0.0, profile_.radius()));
}

/** Distance from the axis at which the cutter touches a plane of \p slope across the axis. */
double
TriangleTouch::steepRadius(double slope, double wider) const
{
  if (slope > steepest_)
    return profile_.radius() + wider;
  return profile_.flatRadius() + wider + profile_.cornerRadius() * slope / std::sqrt(1.0 + slope * slope);
}

/** For a line at the distance \p p from the axis that rises by \p slope >= 0: distance of the touch from its foot. */
double
TriangleTouch::alongEdge(double p, double slope, double wider) const
{
  const double R = profile_.radius() + wider, R1 = profile_.flankRadius() + wider, r = profile_.cornerRadius();
  if (slope == 0.0)
    return 0.0;
  const double to_flank = halfChord(R1, p);
  if (p >= R1 || slope * R1 > steepest_ * to_flank) {
    const double most = halfChord(R, p);
    return slope < steepest_ ? std::min(most, p * slope / std::sqrt((steepest_ - slope) * (steepest_ + slope))) : most;
  }
  if (r == 0.0)
    return to_flank;
  if (profile_.flatRadius() + wider == 0.0)
    return std::min(to_flank, slope * halfChord(r, p) / std::sqrt(1.0 + slope * slope));
  return alongCorner(p, slope, wider);
}

/** The same on the corner, by v, the sine of the lean of the corner: v s = slope l sqrt(1 - v^2) with l = R2 + r v. Newton's
 *  method, kept between two places of different sign by bisection. */
double
TriangleTouch::alongCorner(double p, double slope, double wider) const
{
  const double R2 = profile_.flatRadius() + wider, r = profile_.cornerRadius();
  double low = std::max(0.0, (p - R2) / r), high = cos_angle_;
  const double lean = slope / std::sqrt(1.0 + slope * slope); // sine of the lean; at the touch p is 0
  const double on_ball =
      (std::sqrt(p * p + lean * lean * (R2 + r - p) * (R2 + r + p)) - R2) / r; // of the touch on a ball of the radius R2 + r
  double v = std::clamp(R2 < r ? on_ball : lean, low, high);
  for (int i = 0; i < 60; ++i) {
    const double l = R2 + r * v, s = halfChord(l, p), c = std::sqrt(std::max(0.0, 1.0 - v * v));
    const double value = v * s - slope * l * c;
    (value < 0.0 ? low : high) = v;
    const double change = s + (s > 0.0 ? v * l * r / s : 0.0) - slope * (r * c - (c > 0.0 ? l * v / c : 0.0));
    const double next = v - value / change;
    const bool inside = next > low && next < high;
    const double step = inside ? next - v : 0.5 * (low + high) - v;
    v += step;
    if (std::abs(step) < 1e-8) // the error of the next would be about its square
      break;
  }
  return halfChord(R2 + r * v, p);
}

void
TriangleTouch::touchEdge(const Eigen::Matrix3d& corners, int from, double wider, TouchedTriangle& best) const
{
  const int to = (from + 1) % 3;
  const Eigen::Vector3d a = corners.col(from), d = corners.col(to) - a;
  const double length = d.head<2>().norm(), R = profile_.radius() + wider;
  const auto take = [&](double t, double l) {
    const double height = a.z() + t * d.z() - heightAt(l, wider);
    if (best.found && !(height > best.height))
      return;
    best.found = true;
    best.height = height;
    best.weights.setZero();
    best.weights[from] = 1.0 - t;
    best.weights[to] = t;
  };
  if (length <= 1e-15 * (std::abs(a.x()) + std::abs(a.y()) + std::abs(d.z()))) { // along the axis: take the upper end
    if (const double l = a.head<2>().norm(); l <= R)
      take(d.z() > 0.0 ? 1.0 : 0.0, l);
    return;
  }
  const Eigen::Vector2d u = d.head<2>() / length;
  const double start = a.head<2>().dot(u), p = std::abs(a.x() * u.y() - a.y() * u.x()), slope = d.z() / length;
  const double most = halfChord(R, p), first = std::max(start, -most), last = std::min(start + length, most);
  if (p > R || first > last)
    return;
  const double s = std::clamp(std::copysign(alongEdge(p, std::abs(slope), wider), slope), first, last);
  take(std::clamp((s - start) / length, 0.0, 1.0), std::sqrt(p * p + s * s));
}

/** The touch of the plane if it lies in the triangle; otherwise the best touch of the edges that it is outside of. False if all edges
 *  must be checked. */
bool
TriangleTouch::touchFace(const Eigen::Matrix3d& corners, double wider, double floor, TouchedTriangle& best) const
{
  const Eigen::Vector3d origin = corners.col(0), a = corners.col(1) - origin, b = corners.col(2) - origin;
  const double area = cross(a, b);
  const double size = std::max(a.head<2>().squaredNorm(), b.head<2>().squaredNorm());
  if (!(std::abs(area) > sliver * size))
    return false;
  const Eigen::Vector2d rise = Eigen::Vector2d(a.z() * b.y() - b.z() * a.y(), b.z() * a.x() - a.z() * b.x()) / area;
  const double slope = rise.norm(), l = steepRadius(slope, wider);
  Eigen::Vector3d d = -origin;
  if (slope > 0.0)
    d.head<2>() += l / slope * rise;
  const double profile = heightAt(slope > 0.0 ? l : 0.0, wider);
  if (slope < steep && std::abs(area) > full * size && origin.z() + rise.dot(d.head<2>()) - profile <= floor)
    return true;
  const double w1 = cross(d, b) / area, w2 = cross(a, d) / area;
  const Eigen::Vector3d weights(1.0 - w1 - w2, w1, w2);
  const bool inside = weights.minCoeff() >= 0.0;
  if (inside)
    best = {true, corners.row(2).dot(weights) - profile, weights};
  if (std::abs(area) <= thin * size)
    return false;
  for (int k = 0; k < 3 && !inside; ++k)
    if (weights[(k + 2) % 3] < 0.0)
      touchEdge(corners, k, wider, best);
  return true;
}

TouchedTriangle
TriangleTouch::touch(const Eigen::Matrix3d& corners, double wider, double floor) const
{
  TouchedTriangle best;
  if (!touchFace(corners, wider, floor, best))
    for (int k = 0; k < 3; ++k)
      touchEdge(corners, k, wider, best);
  return best;
}

} // namespace pcl_spiral
