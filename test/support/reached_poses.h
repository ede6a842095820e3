// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a program that a control ran passes the poses it was made from.
 */
#pragma once

#include "support/control_run.h"

#include <pcl_spiral/machine/machine_program.h>

#include <string>
#include <vector>

namespace pcl_spiral::test {

/** A path in passes and the cutter that runs it. */
struct PosesToReach {
  std::vector<ToolPoses> passes;
  double ball_radius = 0.0;    ///< in zones of the pole its centre stays on the path
  std::vector<PoleZone> zones; ///< of the first pass
};

/** Empty if the feed motions pass every pose in order within 1e-3 mm and 1e-3 degree, and with the centre of the ball within
 *  0.005 mm in zones of the pole; else which pose is missed, and by how much. */
std::string missedPose(const ControlRun& run, const PosesToReach& path);

/** Empty if the machine stands, in order, at the positions of all \p blocks, the rotary axes unwound as planned. */
std::string missedBlock(const ControlRun& run, const MachineProgram& program);

} // namespace pcl_spiral::test
