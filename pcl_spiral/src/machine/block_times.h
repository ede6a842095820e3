// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time of every block.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** Sets the minutes of every feed block and the totals in the report. A block runs at \p feed along the contacts,
 *  or along the tip if the contact does not move, or takes as long as its slowest axis needs. */
void setBlockTimes(const Kinematics& kinematics, double feed, MachineProgram& program);

} // namespace pcl_spiral
