// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Chooses the loops between which a spiral runs.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <vector>

namespace pcl_spiral {

/** One boundary: only the rim. Two: the rim and an inner loop. The pointers refer to the loops they were chosen from. */
struct BoundaryChoice {
  const BoundaryLoop* rim = nullptr;
  const BoundaryLoop* inner = nullptr;   ///< null with one boundary, and with all boundaries
  std::vector<const BoundaryLoop*> kept; ///< holes that are boundaries: inner, or with AllBoundaries every real one
};

/** Choose the outer loop. With TwoBoundaries also the longest other loop, of any size; with Automatic a single real hole
 *  (LoopType::Inner), if there is one; with AllBoundaries every real hole. Fails without an outer loop, with TwoBoundaries if there
 *  is no hole, and with Automatic if there are several holes, which the message lists. */
Status chooseBoundaries(const std::vector<BoundaryLoop>& loops, BoundaryMode mode, BoundaryChoice& choice);

} // namespace pcl_spiral
