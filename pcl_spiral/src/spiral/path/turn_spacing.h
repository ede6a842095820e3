// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How close the turns of a path come to each other, and whether it crosses itself.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_path.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** Which points of a path belong to neighbouring turns. */
struct TurnNeighbours {
  std::vector<std::uint8_t> counted; ///< one a point: 1 where it counts
  std::vector<double> along;         ///< one a point, growing along the path: turns, or lengths in mm
  double apart = 0.0;                ///< the least difference of \ref along between a point and both ends of a move
  double within = 0.0;               ///< mm: larger distances are not measured
};

/** What the moves of a path are to each other. */
struct MoveReport {
  std::optional<std::size_t> crossing; ///< the first move that crosses another, see firstSelfCrossing
  ClosestTurns closest;                ///< the smallest distance between a counted point and a move between two such points
};

/** Crossings and closest turns of \p path, in one walk over pairs of moves. \p go_on: as in firstSelfCrossing; after false the figures are
 *  not those of the whole path. Time is nearly linear in the number of points; memory is about 20 bytes per point. */
MoveReport measureMoves(const SpiralPath& path, const TurnNeighbours& neighbours, double slack,
                        const std::function<bool(double)>& go_on = {});

/** measureTurns with the first crossing, if any, into \p crossing. \p go_on: as above. */
void measureTurns(const SpiralPath& path, const SpiralSettings& settings, const std::function<bool(double)>& go_on, ToolpathReport& figures,
                  std::optional<std::size_t>& crossing);

} // namespace pcl_spiral
