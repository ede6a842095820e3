// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A subset of points that is spread evenly enough for neighbourhoods to be round.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** What is left of a cloud when its points are spread evenly. */
struct EvenSpread {
  std::vector<std::uint32_t> kept;   ///< ascending indices of what the blocks were made from; empty: all
  std::vector<std::uint32_t> loners; ///< left out because they stand alone off the others; ascending
  std::size_t surplus = 0;           ///< left out because others lie close by
};

/** Points to keep so that neighbours lie all about each point: of points much closer along scan lines than the lines stand
 *  apart, and of points nearly at one place, some are left out until they lie about as far apart as the lines; beside a
 *  sparser part, so many that the spacing changes by no more than a share of the way gone. Points alone off the others, which
 *  all this would make more important, go too.
 *
 *  All are kept when spread well enough as they are: a look at some neighbourhoods and at the sizes of the blocks
 *  tells. The result depends on the set of points alone, not on their order nor on the number of threads. */
EvenSpread evenSpread(const PointBlocks& blocks);

} // namespace pcl_spiral
