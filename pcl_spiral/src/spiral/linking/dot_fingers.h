// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops too small for bridges, reached by a finger of a neighbour.
 */
#pragma once

#include "loop_cuts.h"
#include "spiral/loops/loop_finder.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Loops longer than this are joined by bridges, step-overs. */
constexpr double longest_dot = 3.4;
/** Entry of joined for a loop that is reached by a finger: the loop itself is not travelled, so no bridge leads to it. */
constexpr std::uint8_t travelled_as_dot = 2;

/** A neighbour of every loop of at most 3.4 step-overs whose entry in \p joined is 0 reaches out to its middle and back, where one
 *  is near enough and free. */
void reachDots(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path);

} // namespace pcl_spiral
