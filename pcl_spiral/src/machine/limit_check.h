// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks that every axis stays within its limits.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Fails if an axis goes beyond a limit. The message names the first such block, the axis, value, limit and
 *  remedy, and the worst value. \p lines: of a program, one for each block; the message then names the line instead of the block. */
Status checkLimits(const Kinematics& kinematics, const std::vector<ProgramBlock>& blocks, const std::vector<std::size_t>& lines = {});

} // namespace pcl_spiral
