// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the moving bodies of a machine stand, and simple solids to show them. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** What moves as one. */
enum class MachineBody {
  Ground,    ///< stands
  Trunnion,  ///< the table axis that carries another one
  Table,     ///< carries the part
  Slide,     ///< X, Y and Z
  OuterHead, ///< the head axis that carries another one
  Spindle    ///< carries the tool
};
constexpr std::size_t machine_bodies = 6; ///< their number

/** The pose of each body. Those that carry the part have the frame of the program with the rotary axes at zero, the others that of the
 *  gauge point; poses lead to the frame of the program with the rotary axes at zero, which does not turn. */
class MachineStand {
public:
  /** With the tip at \p tip in the workpiece frame. */
  MachineStand(const Kinematics& kinematics, const Eigen::Vector3d& tip, const RotaryAngles& angles);

  const Eigen::Isometry3d& of(MachineBody body) const { return poses_[static_cast<std::size_t>(body)]; }
  /** From the part: the workpiece frame. */
  const Eigen::Isometry3d& part() const { return of(MachineBody::Table); }
  /** From the tool: the tip at the origin, the axis along z. */
  const Eigen::Isometry3d& tool() const { return tool_; }

private:
  Eigen::Isometry3d& at(MachineBody body) { return poses_[static_cast<std::size_t>(body)]; }

  std::array<Eigen::Isometry3d, machine_bodies> poses_;
  Eigen::Isometry3d tool_;
};

/** A box with edges along X, Y and Z, or a cylinder. */
struct MachineSolid {
  MachineBody body = MachineBody::Ground;      ///< that it belongs to, in whose frame it is
  Eigen::Vector3d a = Eigen::Vector3d::Zero(); ///< lowest corner, or one end of the axis
  Eigen::Vector3d b = Eigen::Vector3d::Zero(); ///< highest corner, or the other end
  double radius = 0.0;                         ///< of a cylinder; 0: a box
  bool is_axis = false;                        ///< it shows where a rotary axis is
};

/** Table, head, and the places of the rotary axes of \p machine. A machine file has no sizes: they are chosen so that the table holds the
 *  box of the \p part and the spindle is above the tool, which is \p tool_height long. */
std::vector<MachineSolid> machineSolids(const Machine& machine, const Eigen::AlignedBox3d& part, double tool_height);

} // namespace pcl_spiral
