// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The loops of a spiral from the rim to the innermost one, and the places where it goes from one to the next.
 */
#pragma once

#include "loop_cuts.h"
#include "spiral/loops/loop_finder.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** Share of the rim's strip that the path covers at its start. */
constexpr double rim_overlap = 0.8;
/** Share of the innermost strip that the path covers at its end. */
constexpr double core_overlap = 0.6;

/** A strip of a loop in which a spiral leaves it for the next: from u - length to u. */
struct RampStrip {
  std::size_t loop = 0;
  double u = 0.0, length = 0.0; ///< step-overs
  double distance = 0.0;        ///< of u from the strip of the loop inside
};

/** The ramp from strip \p a in to strip \p b of the next loop, at the share \p t of them. */
Eigen::Vector3d onRamp(const CutLoops& loops, const RampStrip& a, const RampStrip& b, double t);

/** Strips of a chain of loops from \p innermost out to a rim, the rim's first: the most even of many chains, or of those that meet the
 *  rim near \p start. Empty if no chain leads out. */
std::vector<RampStrip> findMainChain(const CutLoops& loops, const LoopFinder& finder, std::size_t innermost, std::size_t outer_rim,
                                     const std::optional<Eigen::Vector3d>& start);

/** The same from \p innermost out to a rim, or to the last loop before one whose entry in \p joined is not 0. It is one of the chains
 *  over most loops, and holds at least \p innermost. */
std::vector<RampStrip> findBranch(const CutLoops& loops, const LoopFinder& finder, std::size_t innermost,
                                  const std::vector<std::uint8_t>& joined);

/** Cut the strips out and add ramps. \return the cuts, one a strip. */
std::vector<std::size_t> addRamps(const std::vector<RampStrip>& chain, CutLoops& loops, LinkedPath& path);

} // namespace pcl_spiral
