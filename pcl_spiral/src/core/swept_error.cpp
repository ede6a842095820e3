// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/swept_error.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** Depth of the wedge between two circles of \p radius, with centres \p distance apart, below their common
 *  tangent. */
double
wedge(double radius, double distance)
{
  const double half = 0.5 * distance;
  return radius > half ? radius - std::sqrt(radius * radius - half * half) : half;
}

/** Largest height of the step at the edge between a flank at \p angle and the shank above it, over all sides of the
 *  cutter. On a side that sees the share x of the move, the step is a triangle over the move with an angle
 *  between \p angle and 0, x (h - x cot angle) / sqrt(x^2 + h^2). */
double
stepOfUpperEdge(double angle, double h, double l)
{
  const double x = std::min(l, h * std::tan(0.5 * angle));
  return x > 0.0 ? x * (h - x / std::tan(angle)) / std::hypot(x, h) : 0.0;
}

} // namespace

double
sweptError(const CutterProfile& profile, double height, double distance)
{
  const double h = std::abs(height), l = std::abs(distance), d = std::hypot(h, l), r = profile.cornerRadius();
  if (d == 0.0)
    return 0.0;
  if (l > 2.0 * profile.radius())
    return std::numeric_limits<double>::infinity();
  const double fillet = d < 2.0 * r ? wedge(r, d) : std::numeric_limits<double>::infinity();
  const double edge = std::max(h * l / d, wedge(profile.flatRadius(), l));
  const double below = std::min({fillet, edge, l}), angle = profile.flankAngle();
  return angle > 0.0 ? std::max(below, wedge(profile.radius(), l) + stepOfUpperEdge(angle, h, l)) : below;
}

double
sweptError(const CutterProfile& profile, const CutterPlace& from, const CutterPlace& to)
{
  const double r = profile.cornerRadius(), top = profile.topHeight();
  const Eigen::Vector3d way = to.tip + r * to.axis - from.tip - r * from.axis;
  const double turn = angleBetween(from.axis, to.axis);
  const Eigen::Vector3d axis = (from.axis + to.axis).normalized();
  const double along = way.dot(axis), across = (way - along * axis).norm();
  const double widest = profile.flankAngle() > 0.0 ? profile.radius() : profile.flatRadius();
  const double bow = (widest + std::max(top, r)) * turn * turn / 8.0;
  return sweptError(profile, std::abs(along) + widest * turn, across + std::abs(top - r) * turn) + bow;
}

} // namespace pcl_spiral
