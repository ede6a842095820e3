// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Thinning of points to a distance. Private.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** By point in the order of the blocks: 1 for those kept. One after the other, a point goes when one kept before lies closer
 *  to it than its own \p distance; a distance of 0 keeps it. */
std::vector<std::uint8_t> thinToDistance(const PointBlocks& blocks, const std::vector<float>& distance);

} // namespace pcl_spiral
