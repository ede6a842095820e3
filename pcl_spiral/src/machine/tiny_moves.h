// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Turns during which the linear axes move by next to nothing.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program.h>

#include <vector>

namespace pcl_spiral {

/** The linear part of a block in which a rotary axis turns is 0, or at least this fast, mm/min. In LinuxCNC up to a pre-release of
 *  2.9 a G93 block runs at max(0.1 mm/min, length * F) (inverse_time_rate_straight in interp_inverse.cc; issue 2410): a block of
 *  0.0002 mm and half a turn goes at the limit of the rotary axis, whatever its F. The rest of the factor is for the decimals of the
 *  program: (2, 1, 1) units of the last one, just missed, are written as (1, 0, 0), a 2.45th of the way. */
constexpr double least_linear_rate = 0.25;

/** Makes the linear part of slower blocks exactly 0, in the coordinates of the program (those of the tip with RTCP). The next block
 *  takes their way along. Where the tool would get more than \p tolerance (mm) off its way, its linear axes go on without a turn, and a
 *  block whose own way is longer is divided. The blocks have their times; if the result is true, they need them anew.
 *  \return whether a block changed */
bool holdTinyMoves(const Kinematics& kinematics, double tolerance, std::vector<ProgramBlock>& blocks);

} // namespace pcl_spiral
