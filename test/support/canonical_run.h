// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Programs run by LinuxCNC's interpreter, rs274.
 */
#pragma once

#include "support/scratch_folder.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral::test {

struct CanonicalMotion {
  bool rapid;
  std::array<double, 6> xyzabc;
  double feed;    ///< speed from the interpreter, mm/min
  double spindle; ///< rev/min, below 0 counter-clockwise, 0: off
  bool flood;     ///< the coolant is on
  bool tool_tip;  ///< the kinematics of the tool tip are on (M428)
};

/** A digital output, switched when the next motion begins. */
struct CanonicalOutput {
  bool on;
  int bit;
  std::size_t motions_before;
};

struct CanonicalRun {
  int code;
  std::string messages;
  std::vector<CanonicalMotion> motions;
  std::vector<CanonicalOutput> outputs;
};

/** Minutes that LinuxCNC gives a motion: its speed is that of X, Y and Z, in mm/min, or, where they stand, that of the rotary axes, in
 *  degrees/min (NIST RS274, 2.1.2.5; find_straight_length in interp_find.cc). */
double minutesOf(const CanonicalMotion& from, const CanonicalMotion& to);

/** Runs the interpreter; motions in order. \p settings: a folder with rs274.ini; \p length: of tool 3, mm. */
CanonicalRun interpret(const std::string& program, const ScratchFolder& folder, const std::string& settings = {}, double length = 0.0);

} // namespace pcl_spiral::test
