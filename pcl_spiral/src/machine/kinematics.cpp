// SPDX-License-Identifier: BSD-3-Clause
#include "half_turn.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double pole = 1e-6;      ///< radians: closer to the pole the first angle is meaningless
constexpr double rounding = 1e-12; ///< tolerance of a cosine just above 1
constexpr double upright = 1e-6;   ///< radians: the tool axis of a three-axis machine is no farther from +Z

Eigen::Matrix3d
rotation(const RotaryAxis& axis, double angle)
{
  return Eigen::AngleAxisd(angle, axis.direction).toRotationMatrix();
}

Eigen::Vector3d
turned(const RotaryAxis& axis, double angle, const Eigen::Vector3d& x)
{
  return axis.point + rotation(axis, angle) * (x - axis.point);
}

} // namespace

Kinematics::Kinematics(Machine machine) : machine_(std::move(machine))
{
  const Status status = checkMachine(machine_);
  if (!status.ok())
    throw std::invalid_argument(status.message());
  if (machine_.three_axes)
    machine_.rotary = {}; // they never turn
  for (int i = 0; i < 2; ++i) {
    machine_.rotary[i].direction.normalize();
    sign_[i] = machine_.rotary[i].mount == RotaryMount::Table ? -1.0 : 1.0;
  }
}

Eigen::Vector3d
Kinematics::toolAxis(const RotaryAngles& angles) const
{
  if (machine_.three_axes)
    return Eigen::Vector3d::UnitZ();
  return rotation(machine_.rotary[0], sign_[0] * angles.first) *
         (rotation(machine_.rotary[1], sign_[1] * angles.second) * Eigen::Vector3d::UnitZ());
}

std::optional<RotaryAngles>
Kinematics::anglesOf(const Eigen::Vector3d& axis, Branch branch) const
{
  if (machine_.three_axes)
    return axis.z() > 0.0 && std::hypot(axis.x(), axis.y()) < upright ? std::optional(RotaryAngles()) : std::nullopt;
  const Eigen::Vector3d& d1 = machine_.rotary[0].direction;
  const Eigen::Vector3d& d2 = machine_.rotary[1].direction;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  // d1.u = k + p cos q + s sin q holds for the second angle q and any first angle (Rodrigues).
  const double k = d1.dot(d2) * d2.z(), p = d1.z() - k, s = d1.dot(d2.cross(z));
  const double amplitude = std::hypot(p, s), middle = std::atan2(s, p);
  const double cosine = (d1.dot(axis) - k) / amplitude;
  if (std::abs(cosine) > 1.0 + rounding || !std::isfinite(cosine))
    return std::nullopt;
  const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double one = nearestTurn(sign_[1] * (middle + half), 0.0), other = nearestTurn(sign_[1] * (middle - half), 0.0);
  RotaryAngles angles;
  angles.second = branch == Branch::Larger ? std::max(one, other) : std::min(one, other);
  if (poleAngle(axis) < pole) {
    angles.first = std::nan("");
    return angles;
  }
  const Eigen::Vector3d v = rotation(machine_.rotary[1], sign_[1] * angles.second) * z;
  angles.first = sign_[0] * std::atan2(d1.dot(v.cross(axis)), v.dot(axis) - d1.dot(v) * d1.dot(axis));
  return angles;
}

double
Kinematics::poleAngle(const Eigen::Vector3d& axis) const
{
  if (machine_.three_axes)
    return 0.5 * pi; // there is no pole
  const Eigen::Vector3d& d1 = machine_.rotary[0].direction;
  return std::atan2(d1.cross(axis).norm(), std::abs(d1.dot(axis)));
}

Eigen::Vector3d
Kinematics::tipFromGauge(const RotaryAngles& angles) const
{
  Eigen::Vector3d x(0.0, 0.0, -machine_.tool_length);
  if (machine_.rotary[1].mount == RotaryMount::Head)
    x = turned(machine_.rotary[1], angles.second, x);
  if (machine_.rotary[0].mount == RotaryMount::Head)
    x = turned(machine_.rotary[0], angles.first, x);
  return x;
}

Eigen::Vector3d
Kinematics::programmed(const Eigen::Vector3d& tip, const RotaryAngles& angles) const
{
  if (machine_.three_axes)
    return tip;
  Eigen::Vector3d x = tip + machine_.work_zero;
  if (machine_.rotary[0].mount == RotaryMount::Table)
    x = turned(machine_.rotary[0], angles.first, x);
  if (machine_.rotary[1].mount == RotaryMount::Table)
    x = turned(machine_.rotary[1], angles.second, x);
  return x - tipFromGauge(angles) - Eigen::Vector3d(0.0, 0.0, machine_.tool_length) - machine_.work_zero;
}

Eigen::Vector3d
Kinematics::tipOf(const Eigen::Vector3d& programmed, const RotaryAngles& angles) const
{
  if (machine_.three_axes)
    return programmed;
  Eigen::Vector3d x = gaugePoint(programmed) + tipFromGauge(angles);
  if (machine_.rotary[1].mount == RotaryMount::Table)
    x = turned(machine_.rotary[1], -angles.second, x);
  if (machine_.rotary[0].mount == RotaryMount::Table)
    x = turned(machine_.rotary[0], -angles.first, x);
  return x - machine_.work_zero;
}

} // namespace pcl_spiral
