// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Thinning of points to a distance. Private.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** For each point in the order of the blocks: 1 if it is kept. One after the other, a point is dropped if one kept before lies closer
 *  to it than its own \p distance; a distance of 0 keeps it. */
std::vector<std::uint8_t> thinToDistance(const PointBlocks& blocks, const std::vector<float>& distance);

} // namespace pcl_spiral
