// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops beside the chain of a spiral become spirals of their own.
 */
#pragma once

#include "main_chain.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A spiral along one chain of loops, with the share that it covers of the strips at its ends. */
struct SpiralPass {
  std::vector<RampStrip> chain;         ///< the outermost loop first
  std::vector<std::size_t> cuts;        ///< of the strips
  double lead_in = 0.0, lead_out = 0.0; ///< shares of the first strip before the path enters the loop, and of the last one

  const RampStrip& first() const { return chain.front(); }
  const RampStrip& last() const { return chain.back(); }
  double beginArc() const { return first().u - lead_in * first().length; }
  double endArc() const { return last().u + (lead_out - 1.0) * last().length; }
};

/** Chains over all loops whose entry in \p joined is 0, with their ramps in \p loops. Each leads from the deepest remaining loop out to
 *  a rim or a loop in the path. Dots become fingers of their neighbours, or chains if none is near. The order: from \p end, where the
 *  path ends so far, the tool always goes to the nearest remaining pass. */
std::vector<SpiralPass> findBranches(const LoopFinder& finder, const Eigen::Vector3d& end, std::vector<std::uint8_t>& joined,
                                     CutLoops& loops, LinkedPath& path);

} // namespace pcl_spiral
