// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Positions of a machine between two blocks of a program.
 */
#pragma once

#include "support/machine_oracle.h"
#include "support/test_machines.h"

#include <pcl_spiral/machine/machine_program.h>

#include <cmath>

namespace pcl_spiral::test {

/** Position of the machine at share \p t of the way from \p a to \p b, by the kinematics of the oracle: programmed axes move
 *  linearly, with RTCP those of the tip. */
inline TipAndAxis
onTheWay(const Machine& machine, const ProgramBlock& a, const ProgramBlock& b, double t)
{
  constexpr double degrees = 180.0 / M_PI;
  const auto mix = [t](auto from, auto to) { return from + t * (to - from); };
  const Eigen::Vector3d from = machine.rtcp ? a.tip : a.machine, to = machine.rtcp ? b.tip : b.machine;
  TipAndAxis found = forward(chainOf(machine), {from + t * (to - from), mix(a.angles.first, b.angles.first) * degrees,
                                                mix(a.angles.second, b.angles.second) * degrees});
  if (machine.rtcp)
    found.tip = from + t * (to - from);
  return found;
}

} // namespace pcl_spiral::test
