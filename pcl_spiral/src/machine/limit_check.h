// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks that every axis stays within its limits.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** Fails if an axis goes beyond a limit. The message names the first such block, the axis, value, limit and
 *  remedy, and the worst value. */
Status checkLimits(const Kinematics& kinematics, const std::vector<ProgramBlock>& blocks);

} // namespace pcl_spiral
