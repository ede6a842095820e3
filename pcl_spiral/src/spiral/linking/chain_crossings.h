// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the ramps of a chain cross each other or its loops.
 */
#pragma once

#include "main_chain.h"

namespace pcl_spiral {

/** How often ramps of \p chain, from the rim inward, cross the next ramp or the parts that remain of the two loops they join, beside
 *  the strips. */
std::size_t chainCrossings(const CutLoops& loops, const std::vector<RampStrip>& chain);

} // namespace pcl_spiral
