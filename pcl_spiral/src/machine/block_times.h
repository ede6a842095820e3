// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How long every block takes.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** Sets minutes of every feed block, at \p feed along the contacts (along the tip where the contact stands)
 * or as long as the slowest axis needs, and what that came to in the report. */
void setBlockTimes(const Kinematics& kinematics, double feed, MachineProgram& program);

} // namespace pcl_spiral
