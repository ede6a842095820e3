// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How close the turns of a path come to each other.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_path.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The place where neighbouring turns of \p path are closest: the smallest distance, below \p within mm, between a point that
 *  \p counted marks and a move between two such points at least \p apart away by \p along. \p along grows along the path: turns, or
 *  lengths in mm. Time is nearly linear in the number of points; memory is about 20 bytes per point. */
ClosestTurns closestTurns(const SpiralPath& path, const std::vector<std::uint8_t>& counted, const std::vector<double>& along, double apart,
                          double within);

} // namespace pcl_spiral
