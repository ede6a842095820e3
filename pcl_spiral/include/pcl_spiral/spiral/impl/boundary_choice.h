/** \file
 *  Which of a surface's loops a spiral runs between.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <vector>

namespace pcl_spiral {

/** One boundary: the rim alone. Two: the rim and an inner loop. They point into the loops they were chosen from. */
struct BoundaryChoice {
  const BoundaryLoop* rim = nullptr;
  const BoundaryLoop* inner = nullptr; ///< null with one boundary, and with all
  std::vector<const BoundaryLoop*> kept; ///< holes that are boundaries: inner, or with AllBoundaries every real one
};

/** Choose the outer loop; where two boundaries are asked for the longest other loop, whatever its size; where Automatic finds
 *  a single real hole (LoopType::Inner), that; where all are asked for every real one. Fails without an outer loop, when two are asked for and there is no hole, and
 *  when Automatic finds several holes, which it names. */
Status
chooseBoundaries(const std::vector<BoundaryLoop>& loops, BoundaryMode mode, BoundaryChoice& choice);

} // namespace pcl_spiral
