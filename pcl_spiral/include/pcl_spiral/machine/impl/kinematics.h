// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From tool poses to the axes of a machine and back.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <optional>

namespace pcl_spiral {

/** Kinematics of one machine. With u the tool axis in the workpiece frame, R rotations about the
 *  directions of the axes, and s = -1 for a table, +1 for a head: u = R(d1, s1 q1) R(d2, s2 q2) z. */
class Kinematics {
public:
  /** \throw std::invalid_argument if checkMachine finds a fault */
  explicit Kinematics(Machine machine);

  const Machine& machine() const { return machine_; }

  /** Tool axis in the workpiece frame, unit. */
  Eigen::Vector3d toolAxis(const RotaryAngles& angles) const;

  /** Angles for a unit tool axis. Both are within half a turn of zero. The first is
   *  not a number if the tool axis is along the first rotary axis to 1e-6 radians:
   *  there every first angle reaches it. Nothing if no angles reach \p axis. */
  std::optional<RotaryAngles> anglesOf(const Eigen::Vector3d& axis, Branch branch) const;

  /** Angle between the tool axis and the pole, the line about which
   *  the first rotary axis turns; 0 to 90 degrees, in radians. */
  double poleAngle(const Eigen::Vector3d& axis) const;

  /** X, Y, Z as programmed without RTCP for the tip at \p tip in the workpiece frame:
   *  where the tip would be in the frame of the program with the rotary axes at zero. */
  Eigen::Vector3d programmed(const Eigen::Vector3d& tip, const RotaryAngles& angles) const;
  /** The reverse: the tip in the workpiece frame. */
  Eigen::Vector3d tipOf(const Eigen::Vector3d& programmed, const RotaryAngles& angles) const;

  /** X, Y, Z of the gauge point in machine coordinates, to which the limits apply. */
  Eigen::Vector3d gaugePoint(const Eigen::Vector3d& programmed) const
  {
    return programmed + machine_.work_zero + Eigen::Vector3d(0.0, 0.0, machine_.tool_length);
  }

private:
  Eigen::Vector3d tipFromGauge(const RotaryAngles& angles) const;

  Machine machine_;
  std::array<double, 2> sign_;
};

} // namespace pcl_spiral
