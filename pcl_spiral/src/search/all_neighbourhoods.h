// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The neighbourhoods of all points of a cloud, in parallel. Private.
 */
#pragma once

#include "neighbour_search.h"

namespace pcl_spiral {

/** Calls \p visit(i, neighbourhood) for every point: its \p k nearest, including itself; points of a block one after the
 *  other, blocks on as many threads as given. */
template <typename Visit>
void
forNeighbourhoods(const PointBlocks& blocks, int k, int threads, Visit visit)
{
  const auto count = static_cast<std::int64_t>(blocks.blockCount());
#pragma omp parallel num_threads(threads)
  {
    NeighbourSearch search(blocks, k);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < count; ++b) {
      search.setRun(blocks.blockBox(b));
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i)
        visit(i, search.find(blocks.position(i)));
    }
  }
}

} // namespace pcl_spiral
