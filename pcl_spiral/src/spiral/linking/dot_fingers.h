// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Fingers of loops, which reach neighbours too small for bridges.
 */
#pragma once

#include "loop_cuts.h"
#include "spiral/loops/loop_finder.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Loops longer than this are joined by bridges, step-overs. */
constexpr double longest_dot = 3.4;
/** Entry of joined for a loop that is reached by a finger: the path does not run on the loop, so no bridge leads to it. */
constexpr std::uint8_t travelled_as_dot = 2;

/** Reach every loop of at most 3.4 step-overs whose entry in \p joined is 0: a neighbour, if one is near enough and free, makes a
 *  finger to its middle and back. */
void reachDots(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path);

} // namespace pcl_spiral
