// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moves of a program that are too fast for their neighbours.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A cutting block that is faster than those around it. */
struct HurriedBlock {
  std::size_t block = 0;
  double times = 0.0; ///< its speed, in speeds of its neighbours
};

/** How the contact of the cutter moves on a block. */
struct BlockContact {
  double way = 0.0;  ///< mm
  double turn = 0.0; ///< of the surface normal, radians
};

/** Cutting blocks on which a ball of \p radius moves at more than 1.4 times the median speed of the five blocks before, and of the five
 *  after. In a program with inverse time (G93) each block has its own time: where a block is missing, the next one makes two ways in the
 *  time of one. \p contacts: one per block.
 *
 *  Where a limit slows the blocks around, one that it does not slow looks fast. So the contact must be as much faster than its neighbours,
 *  and 1.2 times as fast as the median of the program. Where a rotary axis turns near its largest rate in the program, that rate sets the
 *  times, and speeds change from block to block: there the way of the block must be 1.4 times as long, too. Sharp edges, where the ball
 *  goes on while its contact stays or jumps, and sharp turns are not looked at. */
std::vector<HurriedBlock> hurriedBlocks(const MachineProgram& program, double radius, const std::vector<BlockContact>& contacts);

} // namespace pcl_spiral
