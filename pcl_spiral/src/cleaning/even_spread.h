// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A subset of points that is spread evenly enough for round neighbourhoods.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** What remains of a cloud when its points are spread evenly. */
struct EvenSpread {
  std::vector<std::uint32_t> kept;     ///< ascending indices in the points of the blocks; empty: all
  std::vector<std::uint32_t> isolated; ///< left out because they are isolated; ascending
  std::size_t surplus = 0;             ///< left out because others lie close by
};

/** Points to keep so that each point has neighbours all round. If points are much closer along scan lines than the lines are to each
 *  other, or nearly at one place, some are left out until they are about as far apart as the lines. Beside a sparser part, so many
 *  are left out that the spacing changes by no more than a share of the distance. Isolated points, which all this would make more
 *  important, are left out too.
 *
 *  All are kept if they are spread well enough. Some neighbourhoods and the sizes of the blocks show this.
 *  The result depends only on the set of points, not on their order or the number of threads. */
EvenSpread evenSpread(const PointBlocks& blocks);

} // namespace pcl_spiral
