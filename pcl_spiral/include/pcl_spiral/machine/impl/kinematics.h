/** \file
 *  From tool poses to the axes of a machine and back.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <optional>

namespace pcl_spiral {

/** Angles of the two rotary axes, radians: first the one nearer to the workpiece. Table-table and head-head
 * machines that are usual turn the tool about the workpiece's Z by the first (C) and tilt it by the second (A
 * or B). */
struct RotaryAngles {
  double first = 0.0;
  double second = 0.0;
};

/** Of the two ways to reach a tool axis the one whose second angle is the larger, or the smaller: (A, C) or
 * (-A, C + 180). */
enum class Branch { Larger, Smaller };

/** Kinematics of one machine. With u the tool axis seen from the workpiece, R rotations about the axes'
 * directions and s -1 for a table, +1 for a head: u = R(d1, s1 q1) R(d2, s2 q2) z. */
class Kinematics {
public:
  /** \throw std::invalid_argument where checkMachine finds a fault */
  explicit Kinematics(Machine machine);

  const Machine&
  machine() const
  {
    return machine_;
  }

  /** Tool axis seen from the workpiece, unit. */
  Eigen::Vector3d toolAxis(const RotaryAngles& angles) const;

  /** Angles for a unit tool axis; the second lies within half a turn of zero, the first too, and it is not a
   * number where the tool axis lies along the first rotary axis to 1e-6 radians: there every angle does.
   * Nothing where no angles reach \p axis. */
  std::optional<RotaryAngles> anglesOf(const Eigen::Vector3d& axis, Branch branch) const;

  /** Angle between the tool axis and the pole, the line about which the first rotary axis turns; 0 to 90
   * degrees, radians. */
  double poleAngle(const Eigen::Vector3d& axis) const;

  /** X, Y, Z that are programmed without RTCP for the tip at \p tip in the workpiece's frame: where the tip
   * would be in the program's frame if the rotaries were at zero. */
  Eigen::Vector3d programmed(const Eigen::Vector3d& tip, const RotaryAngles& angles) const;
  /** Back: the tip in the workpiece's frame. */
  Eigen::Vector3d tipOf(const Eigen::Vector3d& programmed, const RotaryAngles& angles) const;

  /** X, Y, Z of the gauge point in machine coordinates, which the limits speak of. */
  Eigen::Vector3d
  gaugePoint(const Eigen::Vector3d& programmed) const
  {
    return programmed + machine_.work_zero + Eigen::Vector3d(0.0, 0.0, machine_.tool_length);
  }

private:
  Eigen::Vector3d tipFromGauge(const RotaryAngles& angles) const;

  Machine machine_;
  std::array<double, 2> sign_;
};

} // namespace pcl_spiral
