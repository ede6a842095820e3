// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time of every block.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program_generator.h>

namespace pcl_spiral {

/** The tool moves by at least 1 / tool_way, and at most tool_way, of the way that the feed counts. */
constexpr double tool_way = 2.0;

/** The feed of moves of \p section, mm/min. */
double feedOf(const ProgramSettings& settings, BlockSection section);

/** The way that the feed counts for a move of the contact by \p contact and of the tool by \p tool mm: w of setBlockTimes. */
double countedWay(double contact, double tool);

/** The time of the move from \p a to \p b: at its feed, or as the slowest axis needs, which alone counts for a rapid. */
double moveMinutes(const Kinematics& kinematics, const ProgramSettings& settings, const ProgramBlock& a, const ProgramBlock& b);

/** Sets the minutes of every feed block and the totals in the report.
 *
 *  Let c, t, o be the ways of the contact, the tip and the ball's centre in the block (mm; o = t without a ball radius), m = max(t, o),
 *  f the feed of the block's section (mm/min), and r_i the largest rate of axis i (mm/min or radians/min). Then
 *
 *      minutes = max(w / f, max over i and the block of |dq_i / ds| / r_i),   w = c, but not below m / 2 and not above 2 m,
 *
 *  and w = m where the contact stands, as in leads; q_i(s) is the axis at share s of the block. So
 *  - neither the tip nor the centre is faster than twice the feed, however short the way of the contact;
 *  - where the contact jumps, as a ball in a groove does from wall to wall, the tool is at half the feed and does not stall;
 *  - where tip, centre and contact stand, the axes turn at their largest rate.
 *
 *  Tip and centre both count. The tip, since it moves while the centre stands (an axis that is blended at the pole). The centre, since
 *  the chip is its way: on a surface of radius R a ball of radius r has o = c (1 + r / R), R negative in a hollow, and a thin layer gives
 *  a chip as thick as sqrt(c o) / minutes. With w at least o / 2, that chip is at most sqrt(2) times as thick as on a
 *  plane, except where the contact jumps. A ball that rolls over an edge has its tip and contact nearly at rest, and its centre moves.
 *
 *  With RTCP the linear axes do not move evenly, since the control bends their way: their rates are taken in the block, not of its ends. */
void setBlockTimes(const Kinematics& kinematics, const ProgramSettings& settings, MachineProgram& program);

} // namespace pcl_spiral
