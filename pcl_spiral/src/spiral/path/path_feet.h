// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The feet of the points of a path on the surface.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Feet of \p points, which lie within the rim of \p surface. Beside gaps the fits are up to four times as wide. In creases that
 *  no fit follows, a point keeps its position, gets the normal of the points about it, and counts as far from the cloud, so that it
 *  is reported like a point over a gap. A foot is invalid if its point still lies beyond the rim. */
void pathFeet(const Surface& surface, const Polyline& points, std::vector<SurfaceFoot>& feet);

} // namespace pcl_spiral
