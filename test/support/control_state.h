// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Modal state and axes of a control, whatever its language; what it refuses.
 */
#pragma once

#include "support/control_angles.h"
#include "support/control_run.h"

#include <map>
#include <stdexcept>

namespace pcl_spiral::test {

/** Why a control stops. */
struct ControlFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** What a line left as it is for the lines after it. */
struct ModalState {
  bool metric = false, absolute = false, plane_xy = false;
  bool feed_mode = false, inverse_time = false;
  double spindle_speed = 0.0;
  int spindle = 0; ///< 1 clockwise, -1 counter-clockwise, 0 off
  std::set<std::string> coolant;
  int tool = 0;
  bool length = false;   ///< of the tool, is counted
  bool offset = false;   ///< of the work, is chosen
  bool tool_tip = false; ///< tool-tip control
  bool vectors = false;  ///< tool-tip control takes vectors
  bool smoothing = false;
  bool ended = false;
};

/** Where a line sends the axes, and how fast. */
struct MotionWords {
  std::array<std::optional<double>, 3> xyz;
  std::map<char, double> degrees;
  std::optional<Eigen::Vector3d> vector; ///< of the tool
  bool machine_frame = false;
  bool great_circle = false;           ///< the tool turns in one plane between two vectors; else the angles move evenly
  std::optional<double> minutes, feed; ///< of a feed move: its time, or mm/min of the tip
};

/** A control and its machine. The languages set the modal state; every change of the machine is checked here. */
class Control {
public:
  explicit Control(const ControlJob& job);

  ModalState modal;
  const ControlJob& job() const { return job_; }

  void callTool(int number);        ///< the spindle stops
  void startSpindle(int direction); ///< of M3 and M4
  void chooseOffset(const std::string& word);
  void requireLengthOf(int number) const; ///< of the tool in the spindle
  void requireMetric(bool metric);
  void setToolTip(bool on, bool vectors = false);
  void move(const MotionWords& words, bool rapid);
  void requireEnd() const; ///< the state in which a program may end

  std::size_t line = 0; ///< of the text
  std::vector<ControlMotion> motions;

private:
  void requireReady(const MotionWords& words, bool rapid) const;
  AxisPosition target(const MotionWords& words) const;
  AxisPosition onTheWay(const MotionWords& words, const AxisPosition& from, const AxisPosition& to, const AxisPosition& before,
                        double share) const;
  double minutesOf(const MotionWords& words, const AxisPosition& from, const AxisPosition& to) const;
  void requireSpeeds(const AxisPosition& from, const AxisPosition& to, double minutes, double excess) const;
  void requireTravel(const AxisPosition& at) const;
  void requireClear(const AxisPosition& at, bool rapid) const;
  void requireNoSwing(const AxisPosition& from, const AxisPosition& to) const;

  ControlJob job_;
  AxisPosition at_; ///< at the begin a little below the retract height, the rest at zero
  bool cut_ = false, first_under_tip_ = false;
};

} // namespace pcl_spiral::test
