// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the points of a path stand on the surface.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Feet of \p points, which lie within the rim of \p surface. Beside gaps fits are up to four times as wide. In creases that no fit
 *  follows, a point stands where it is, its normal that of the points about it, and its nearest point counts as far away, so
 *  that it is told as one over a gap. Invalid where a point lies beyond the rim all the same. */
void pathFeet(const Surface& surface, const Polyline& points, std::vector<SurfaceFoot>& feet);

} // namespace pcl_spiral
