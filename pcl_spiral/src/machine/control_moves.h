// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The blocks of a program as a control plans them.
 */
#pragma once

#include "core/control_move.h"
#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/machine/machine_program.h>

#include <vector>

namespace pcl_spiral {

/** With the usual accelerations of machine.h where \p machine has none. */
AxisDynamics dynamicsOf(const Machine& machine);

/** The moves of \p program that have a length, at \p feed times its feeds. */
std::vector<ControlMove> controlMoves(const MachineProgram& program, const ControlModel& control, const AxisDynamics& axes,
                                      double feed = 1.0);

} // namespace pcl_spiral
