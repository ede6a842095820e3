// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Controls of the tests: each reads the text of a whole program in its language, keeps the modal state, moves the
 *  machine, and stops at the first line that a control would refuse or that would break something.
 */
#pragma once

#include "support/machine_oracle.h"

#include <pcl_spiral/io/program_writer.h>

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** Travel and largest speed of one axis: mm and mm/min, or degrees and degrees/min. */
struct AxisTravel {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double largest_speed = std::numeric_limits<double>::infinity();
};

/** What stands in the shop: the machine, the part, the cutter, and what the job sheet asks for. */
struct ControlJob {
  MachineChain real;                ///< with the place of the part and the length of the cutter as they are
  std::array<AxisTravel, 3> linear; ///< of the gauge point
  std::array<AxisTravel, 2> rotary; ///< as real.rotary

  MachineChain set;           ///< the same as set in the control: work offset and tool table
  std::string offset = "G54"; ///< that is set; Heidenhain: the number of the preset, empty: the active one
  int tool = 0;               ///< 0: the one in the spindle; no call is expected
  double spindle_speed = 12000.0;
  bool clockwise = true;
  std::string coolant;                                         ///< the code that switches it on; empty: dry
  std::string kinematics_on = "M428", kinematics_off = "M429"; ///< of LinuxCNC
  bool tool_tip = true;                                        ///< tool-tip control is on while the tool cuts
  std::optional<double> retract_z;                             ///< machine coordinate; programs begin and end there
  std::set<std::string> hooks;                                 ///< lines of the shop's own, let through

  double largest_feed = std::numeric_limits<double>::infinity(); ///< of the tip against the part, mm/min
  /** Distance of the cutter and its shank from the finished part; below zero: inside. */
  std::function<double(const TipAndAxis&)> clearance = [](const TipAndAxis&) { return std::numeric_limits<double>::infinity(); };
  double first_step = 0.01; ///< so far may the first block under tool-tip control move X and Y, mm
  double gouge = 0.01;      ///< so deep may feed moves cut into the finished part, mm
};

/** One motion, at its end. */
struct ControlMotion {
  std::size_t line = 0; ///< of the text, from 1
  bool rapid = false;
  bool tool_tip = false;                           ///< under tool-tip control
  double minutes = 0.0;                            ///< of a feed move
  Eigen::Vector3d gauge = Eigen::Vector3d::Zero(); ///< in machine coordinates
  std::array<double, 2> degrees{};                 ///< unwound
  TipAndAxis at;                                   ///< the real cutter against the real part
};

struct ControlRun {
  std::vector<ControlMotion> motions;
  std::vector<std::pair<std::string, std::size_t>> hooks; ///< lines of the shop, and the motions before each
  std::string fault;                                      ///< "line 12 'G1 X...': why it was refused"; empty: the program ran to its end
};

/** Time of all feed moves. */
inline double
feedMinutes(const ControlRun& run)
{
  double minutes = 0.0;
  for (const ControlMotion& motion : run.motions)
    minutes += motion.minutes;
  return minutes;
}

/** Runs the text of a program. */
ControlRun runProgram(const std::string& text, Dialect dialect, const ControlJob& job);

} // namespace pcl_spiral::test
