// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The true time of a program on LinuxCNC: its trajectory planner, tpmod, run in virtual time. Programs that use it export their
 *  symbols (ENABLE_EXPORTS), because the module calls them; see linuxcnc_module.h.
 */
#pragma once

#include "support/canonical_run.h"

#include <array>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** Limits of X Y Z A B C: mm/s and mm/s2, degrees/s and degrees/s2. */
struct LinuxCNCAxes {
  std::array<double, 6> velocity{}, acceleration{};
};

/** Times of the motions from one place on. */
struct LinuxCNCTime {
  std::string fault;        ///< why there is no time; empty: there is one
  double seconds = 0.0;     ///< of all
  std::vector<double> ends; ///< when the motion ended, s; the first is where the run begins, at 0
};

/** Whether Debian's package has been there when the tests were built, and its module is there now. */
bool hasLinuxCNCPlanner();

/** Runs \p motions after the first, whose place is the start. \p tolerance: of G64 P, mm; 0: exact path. */
LinuxCNCTime runLinuxCNC(const std::vector<CanonicalMotion>& motions, const LinuxCNCAxes& axes, double tolerance);

} // namespace pcl_spiral::test
