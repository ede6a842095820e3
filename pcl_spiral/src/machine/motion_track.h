// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the tool of a program is at any time.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/motion_time.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A program in one moment. */
struct MotionFrame {
  double seconds = 0.0;                            ///< since the begin
  double length = 0.0;                             ///< way of the tip from end to end of each block up to here, mm
  std::size_t block = 0;                           ///< that the machine is in
  double share = 1.0;                              ///< of this block
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();   ///< in the workpiece frame, mm
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< in the workpiece frame, unit
  RotaryAngles angles;                             ///< radians
  double feed = 0.0;                               ///< mean of the tip over the block, mm/min
  double asked = 0.0;                              ///< feed of the tip that the block asks for, mm/min; 0: a rapid
};

/** A program in time. In a block the tool moves evenly, as poseOnMove says; a block takes the time that the model of the control gives it.
 *  Memory: 16 bytes a block, and the program. */
class MotionTrack {
public:
  MotionTrack() = default;
  /** \p time: of this program. \p axis_arcs: see ProgramFile. \throw std::invalid_argument on a machine with a fault */
  MotionTrack(MachineProgram program, const MotionTime& time, bool axis_arcs = false);

  const MachineProgram& program() const { return program_; }
  /** Of its machine. There must be a program. */
  const Kinematics& kinematics() const { return kinematics_.front(); }
  std::size_t blocks() const { return ends_.size(); }
  double seconds() const { return ends_.empty() ? 0.0 : ends_.back(); }
  double length() const { return ways_.empty() ? 0.0 : ways_.back(); }
  /** When block \p block ends, s. */
  double endOf(std::size_t block) const { return ends_[block]; }
  /** The same of every block. */
  const std::vector<double>& ends() const { return ends_; }

  /** At \p seconds since the begin; before the first block, and after the last, at their ends. There must be a block. */
  MotionFrame at(double seconds) const;
  /** The mean feed of the tip over block \p block, mm/min. */
  double feedIn(std::size_t block) const;
  /** The feed of the tip that it asks for, mm/min; 0: a rapid. */
  double askedIn(std::size_t block) const;
  /** When the tip has made \p length mm of its way. */
  double secondsAt(double length) const;
  /** When the machine is at share \p share of block \p block, s. */
  double secondsIn(std::size_t block, double share) const;

private:
  double took(std::size_t block) const { return block > 0 ? ends_[block] - ends_[block - 1] : 0.0; }
  double wayOf(std::size_t block) const { return block > 0 ? ways_[block] - ways_[block - 1] : 0.0; }
  RotaryAngles anglesAt(const ProgramBlock& from, const ProgramBlock& to, double share, const Eigen::Vector3d& axis) const;

  MachineProgram program_;
  bool axis_arcs_ = false;
  std::vector<Kinematics> kinematics_; ///< of the machine; none without a program
  std::vector<double> ends_, ways_;    ///< at the end of each block: s, mm
};

} // namespace pcl_spiral
