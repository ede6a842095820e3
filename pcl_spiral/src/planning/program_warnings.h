// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What is to be said of a machine program.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** Where axes are blended, blocks are slowed or the first axis unwinds, and that nothing retracts the tool before the start. */
Diagnostics programWarnings(const MachineProgram& program);

/** Refuses a program in which the beam nearly stops: it would burn the part. */
Status checkBeam(const MachineProgram& program);

} // namespace pcl_spiral
