// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface that continues beyond the part of a scan that was chosen.
 */
#pragma once

#include <pcl_spiral/fit/surface_foot.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** A piece of a surface of second order about a foot. Lengths in mm. */
struct SurfacePatch {
  SurfaceFoot foot;
  double extent = 0.0; ///< half its width
};

/** Patches of the surface that continues \p part among the points \p beside it, which a crop or a region left out: what a ball of \p radius
 *  on the part could touch. A point that stands out of this surface by more than its noise is a patch of its own. Points apart from the
 *  surface, and clusters on it, are things, and have no patch. Empty if no ball on a point of the part has one of \p beside in it. */
std::vector<SurfacePatch> surfaceBeyond(const Surface& part, const std::vector<Eigen::Vector3f>& beside, double radius);

} // namespace pcl_spiral
