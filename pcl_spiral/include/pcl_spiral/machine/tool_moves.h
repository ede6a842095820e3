// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path with its leads as moves of the tool alone, for robots and post processors that know their own machine.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <vector>

namespace pcl_spiral {

/** One straight move of the tool in the workpiece frame. */
struct ToolMove {
  BlockSection section = BlockSection::Cut; ///< purpose of the move
  bool rapid = false;                       ///< at rapid speed, without feed
  ToolPose pose;                            ///< at the end of the move; off the path, the pose of the end of the path, moved with the tip
  double minutes = 0.0;                     ///< time of the move; 0 for rapids and for the first move
};

using ToolMoves = std::vector<ToolMove>; ///< Moves in travel order; the first has no way to it.

/** Adds leads to \p passes: one list of moves for each, from above the part to above the part. The leads are those that
 *  MachineProgramGenerator makes with the same \p settings: lead, clearance, along the tool axis to the rapid height, then up to the top,
 *  which is rapid_height above the highest tip and above clear_box. Up is +z; if the axis of a pose points below the horizontal, up is the
 *  mean of all axes. Times are those of MachineProgramGenerator, without the axes of a
 *  machine: where the path cuts, the contact moves at the feed, and the tool at most at twice the feed. Empty passes are left out. */
std::vector<ToolMoves> ledPasses(const std::vector<ToolPoses>& passes, const ProgramSettings& settings);

/** The moves of \p program in the workpiece frame, without those that only turn the rotary axes back. The contact of a pose is its tip: a
 *  program has no contacts. */
ToolMoves movesOf(const MachineProgram& program);

/** The moves as the blocks of a machine that reaches every axis (xyzacTrunnion), one pass after the other. For LeadCheck, which then
 *  looks at all moves that do not cut: on each of them the axis stays, but above the part from pass to pass. */
MachineProgram programOf(const std::vector<ToolMoves>& passes);

} // namespace pcl_spiral
