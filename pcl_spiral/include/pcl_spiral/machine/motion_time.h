// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time that a control needs for a program, where it goes, and what would gain most.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/machine/machine_program.h>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** The values of \p kind with what \p machine says of its control. */
ControlModel controlModel(ControlKind kind, const Machine& machine);

/** Time of each block and of all. */
struct MotionTime {
  double seconds = 0.0;       ///< of all
  std::vector<double> blocks; ///< of each block, s; 0 for the first, where the program begins
};

/** The time of \p program on \p control; nothing if a place or a time of it is not finite.
 *
 *  A block has a length l, that of X Y Z or, where they stand, that of the rotary axes; the speed v = l / ProgramBlock::minutes that its F
 *  asks for; and an acceleration with which no axis exceeds its own. Rapids run as fast as the axes allow. Between two blocks the rule of
 *  the control gives the largest speed. A pass backwards, over the look-ahead, and one forwards lower these speeds to those that the
 *  accelerations reach. Each block is then a trapezoid, or an S-curve if machine and control limit the jerk.
 *
 *  The tolerance at corners is that of the machine, else \p tolerance, mm, else that of the control; 0: it stops after every block
 *  (LinuxCNC: unless a kink needs no arc). */
std::optional<MotionTime> motionTime(const MachineProgram& program, const ControlModel& control, std::optional<double> tolerance = {});

/** Where the time goes. Its parts are differences of the model without one cause after the other, and are all of MotionTime::seconds. s */
struct MotionLosses {
  double at_feed = 0.0;      ///< every block at its feed, rapids at the largest rates
  double ramps = 0.0;        ///< to start, to stop, and to change the feed
  double corners = 0.0;      ///< to change the direction
  double short_blocks = 0.0; ///< because the look-ahead ends, or a block is shorter than a cycle
  double rotary = 0.0;       ///< because the control does not round corners of rotary moves
};

/** What a change would bring. */
enum class MotionChange {
  Feed,          ///< half as much again
  Acceleration,  ///< of every axis, twice
  Tolerance,     ///< at corners, twice
  RotaryBlend,   ///< a control that rounds corners of rotary moves, too
  ChordError,    ///< of the path, twice
  AxisSmoothing, ///< of the tool axes, over a longer way
  LongerBlocks   ///< blocks left out within the chord error (ProgramSettings::thinning)
};

/** Its time. */
struct MotionGain {
  MotionChange change = MotionChange::Feed; ///< what is changed
  double seconds = 0.0;                     ///< less than now; below 0: more
};

/** A program on a control. */
struct MotionStudy {
  Status status;                 ///< fails if a place or a time of the program is not finite
  ControlModel control;          ///< the control
  double tolerance = 0.0;        ///< at corners, mm
  bool usual_axes = false;       ///< an axis of the machine has no limit of acceleration: the usual one was taken
  MotionTime time;               ///< of the program
  MotionLosses losses;           ///< of this time
  std::vector<MotionGain> gains; ///< the largest first
};

/** Adds to \p study what \p change gains, whose program takes \p seconds. */
void addGain(MotionChange change, double seconds, MotionStudy& study);

/** Runs the model as often as losses and gains need. The gains of the last three changes are not among them: they need another
 *  program. Plan again, and add them by addGain. */
MotionStudy studyMotion(const MachineProgram& program, const ControlModel& control, std::optional<double> tolerance = {});

} // namespace pcl_spiral
