// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops beside the chain of a spiral, joined to their neighbours.
 */
#pragma once

#include "loop_cuts.h"
#include "spiral/loops/loop_finder.h"

#include <vector>

namespace pcl_spiral {

/** Join every loop whose entry in \p joined is 0 to the others by a bridge; a dot is joined as a finger of a neighbour.
 *  \return the first loop without a neighbour beside it, or loops.size(). */
std::size_t joinLoops(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path);

} // namespace pcl_spiral
