// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether every axis stays within its limits.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** Failed where an axis goes beyond a limit: the first block that does so, axis, value, limit and remedy, and
 * the worst. */
Status checkLimits(const Kinematics& kinematics, const std::vector<ProgramBlock>& blocks);

} // namespace pcl_spiral
