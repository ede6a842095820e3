// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines and words that a shop or a machine builder gives for its programs.
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Lines of program text. They may hold these names in braces, which a program replaces: {spindle} its speed in rev/min, {tool} its
 *  number, {part} the title, {safe_z} Machine::retract_z in mm, {feed} in mm/min, {tolerance} of the smoothing call in mm, {offset} the
 *  work offset. */
struct ShopLines {
  std::vector<std::string> header;     ///< after units and plane, before the first retract
  std::vector<std::string> footer;     ///< after the last retract, before the end of the program
  std::vector<std::string> pass_begin; ///< before each run of cutting blocks, where the tool is at the first point
  std::vector<std::string> pass_end;   ///< after each of these runs
};

/** Words of one control where they differ from machine to machine. Empty: those of the language, or none. */
struct ControlWords {
  std::string tip_control_on;                            ///< LinuxCNC with RTCP: kinematics of the tool tip, such as M428
  std::string tip_control_off;                           ///< LinuxCNC with RTCP: identity kinematics, such as M429
  std::string mist;                                      ///< coolant as mist; M7
  std::string flood;                                     ///< coolant; M8
  std::string through;                                   ///< coolant through the spindle, such as M88; no language has a word for it
  std::string coolant_off;                               ///< M9
  std::optional<std::vector<std::string>> smoothing_on;  ///< lines instead of those of the language; no lines: no call
  std::optional<std::vector<std::string>> smoothing_off; ///< the same at the end
};

} // namespace pcl_spiral
