// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Outlines inside the rims of a surface. Private to spiral.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Replace each loop of type Outer or Inner by the line \p margins[i] mm inside it along \p surface; 0 keeps the loop. */
Status moveInside(const Surface& surface, const std::vector<double>& margins, std::vector<BoundaryLoop>& loops);

/** A loop along \p curve, which lies on \p surface: its points are the nearest of the scan. Corners are its sharp bends. */
BoundaryLoop loopAlong(const Surface& surface, Polyline curve, LoopType type);

} // namespace pcl_spiral
