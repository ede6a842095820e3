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

/** Cutting blocks on which a ball of \p radius moves at more than 1.4 times the median speed of the five blocks before, and of the five
 *  after. In a program with inverse time (G93) each block has its own time: where a block is missing, the next one makes two ways in the
 *  time of one. A sharp edge can look the same. Where a rotary axis turns near
 *  its largest rate in the program, that rate sets the times, and speeds change from block to block: there the way of the block must be 1.4
 *  times as long, too. */
std::vector<HurriedBlock> hurriedBlocks(const MachineProgram& program, double radius);

} // namespace pcl_spiral
