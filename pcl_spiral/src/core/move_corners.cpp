// SPDX-License-Identifier: BSD-3-Clause
#include "move_corners.h"

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double straight = 1e-6;      ///< radians: no corner
constexpr double sharpest = 3.1066860; ///< radians, 178 degrees: the way goes back, and no arc fits

/** The acceleration that every direction in the plane of \p a and \p b allows. */
double
planeAcceleration(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const AxisDynamics& axes)
{
  const Eigen::Vector3d normal = a.cross(b).normalized();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    least = std::min(least, axes.acceleration[i] / std::max(1e-9, std::sqrt(1.0 - std::min(1.0, normal[i] * normal[i]))));
  return least;
}

/** The radius of the arc whose middle is \p tolerance from a corner of \p angle. */
double
arcRadius(double angle, double tolerance)
{
  const double sine = std::cos(0.5 * angle);
  return tolerance * sine / (1.0 - sine);
}

double
angleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return angleBetween(a, b);
}

MoveCorner
arcCorner(const ControlMove& before, const ControlMove& after, const ControlModel& control, const AxisDynamics& axes, double tolerance)
{
  const Eigen::Vector3d a = before.way.head<3>() / before.length, b = after.way.head<3>() / after.length;
  const double asked = std::min(before.speed, after.speed), angle = angleOf(a, b);
  MoveCorner corner;
  corner.rule = CornerRule::Arc;
  corner.speed = asked;
  const double jump = ((b - a).array().abs() / axes.acceleration.head<3>().array()).maxCoeff() * asked / control.cycle;
  if (angle < straight || jump < control.kink) {
    corner.lost_share = jump < control.kink ? jump : control.kink; // at an endless speed it is not a number
    return corner;
  }
  if (angle > sharpest)
    return {};
  if (!(tolerance > 0.0)) {
    MoveCorner stop;
    stop.lost_share = control.kink;
    return stop;
  }
  const double plane = planeAcceleration(a, b, axes), normal = control.arc_normal * plane, tangent = std::tan(0.5 * angle);
  const double most = std::min({0.5 * before.length, 0.5 * after.length, asked * asked / plane});
  const double radius = std::min(arcRadius(angle, tolerance), most / tangent);
  corner.speed = std::min(asked, std::sqrt(normal * radius));
  if (const double kinked = asked * control.kink / jump; kinked > corner.speed) {
    corner.speed = kinked;
    corner.lost_share = control.kink;
    return corner;
  }
  corner.cut = radius * tangent;
  corner.arc = radius * angle;
  corner.arc_acceleration = control.arc_tangential * plane;
  return corner;
}

/** The slower move has to be this slow before the next begins: twice what the tolerance allows as a way of slowing down. */
MoveCorner
overlapCorner(const ControlMove& before, const ControlMove& after, double tolerance)
{
  MoveCorner corner;
  corner.rule = CornerRule::Overlap;
  const double share = std::sin(0.5 * angleOf(before.way.head<3>(), after.way.head<3>()));
  corner.speed =
      share > straight ? 2.0 * std::sqrt(0.5 * before.acceleration * tolerance / share) : std::numeric_limits<double>::infinity();
  return corner;
}

/** A parabola from a way d before the corner to d behind it is |b - a| d / 4 from the corner, and its acceleration is (b - a) v2 / 2 d. */
MoveCorner
roundedCorner(const ControlMove& before, const ControlMove& after, const AxisDynamics& axes, double tolerance)
{
  const AxisValues change = after.way / after.length - before.way / before.length;
  const double linear = change.head<3>().norm();
  double d = 0.5 * std::min(before.length, after.length);
  if (linear > straight)
    d = std::min(d, 4.0 * tolerance / linear);
  MoveCorner corner;
  corner.rule = CornerRule::AxisRounding;
  corner.speed = std::min(before.speed, after.speed);
  for (int i = 0; i < change.size(); ++i)
    if (std::abs(change[i]) > straight)
      corner.speed = std::min(corner.speed, std::sqrt(2.0 * d * axes.acceleration[i] / std::abs(change[i])));
  return corner;
}

MoveCorner
jumpCorner(const ControlMove& before, const ControlMove& after, const AxisDynamics& axes, double time)
{
  const AxisValues change = (after.way / after.length - before.way / before.length).cwiseAbs();
  MoveCorner corner;
  corner.rule = CornerRule::AxisJump;
  corner.speed = std::min(before.speed, after.speed);
  for (int i = 0; i < change.size(); ++i)
    if (change[i] > straight)
      corner.speed = std::min(corner.speed, time * axes.acceleration[i] / change[i]);
  return corner;
}

MoveCorner
freeCorner(const ControlMove& before, const ControlMove& after)
{
  MoveCorner corner;
  corner.rule = CornerRule::Free;
  corner.speed = std::min(before.speed, after.speed);
  return corner;
}

MoveCorner
deviationCorner(const ControlMove& before, const ControlMove& after, double tolerance)
{
  MoveCorner corner;
  corner.rule = CornerRule::JunctionDeviation;
  corner.speed = std::min(before.speed, after.speed);
  const double cosine = before.way.dot(after.way) / (before.way.norm() * after.way.norm());
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  if (angle > sharpest)
    return {};
  if (angle > straight)
    corner.speed = std::min(corner.speed, std::sqrt(std::min(before.acceleration, after.acceleration) * arcRadius(angle, tolerance)));
  return corner;
}

} // namespace

MoveCorner
cornerBetween(const ControlMove& before, const ControlMove& after, const ControlModel& control, const AxisDynamics& axes, double tolerance)
{
  if (control.stops_at_rapids && before.rapid != after.rapid)
    return {};
  const CornerRule rule = before.turns || after.turns ? control.rotary_corner : control.corner;
  if (!(tolerance > 0.0) && rule != CornerRule::Arc && rule != CornerRule::Free)
    return {};
  switch (rule) {
  case CornerRule::Stop:
    return {};
  case CornerRule::Overlap:
    return overlapCorner(before, after, tolerance);
  case CornerRule::Arc:
    return arcCorner(before, after, control, axes, tolerance);
  case CornerRule::AxisRounding:
    return roundedCorner(before, after, axes, tolerance);
  case CornerRule::AxisJump:
    return jumpCorner(before, after, axes, control.jump_time);
  case CornerRule::Free:
    return freeCorner(before, after);
  case CornerRule::JunctionDeviation:
    return deviationCorner(before, after, tolerance);
  }
  return {};
}

} // namespace pcl_spiral
