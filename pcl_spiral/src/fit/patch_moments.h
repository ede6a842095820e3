// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Weighted moments of the points of a patch. Private.
 */
#pragma once

#include "patch_search.h"

namespace pcl_spiral {

/** Sums over the points (a, b) of a plane with height h, all over the patch's radius, with the weight
 *  (1 - a^2 - b^2)^3: of a^i b^j (named by i u's and j v's) and of a^i b^j h (the same after f). */
struct Moments {
  float w, u, v, uu, uv, vv, uuu, uuv, uvv, vvv, uuuu, uuuv, uuvv, uvvv, vvvv;
  float f, fu, fv, fuu, fuv, fvv, ff;
  float mean_u, mean_v; ///< without weight
};

/** \p frame: nine floats, the axes of a, b and h over the radius. */
void momentsOf(const Patch& patch, const float* frame, Moments& moments);

} // namespace pcl_spiral
