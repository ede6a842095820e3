// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The remedy for a scan with more noise than a surface may have.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {

/** What to do with points whose \p noise, mm, at this \p spacing, hides the surface. Thinning does not help: a point that stays keeps
 *  its noise. A local fit with a radius of 20 noises leaves about 0.07 spacings of noise, whatever the spacing is. A fit wider than eight
 *  spacings is not named: folds and ribs of the part have that width, and with so much scatter nothing tells them from noise. */
inline Diagnostic
smoothingRemedy(double noise, double spacing)
{
  constexpr double radius = 20.0; // of the noise
  constexpr double widest = 8.0;  // spacings: two folds of the least radius that a scan shows, two spacings, side by side
  if (!(radius * noise <= widest * spacing))
    return "such scatter cannot be told from folds of the part with too few points, and smoothing would remove both: "
           "{scan more densely}, or scan and cut one sheet at a time";
  return Diagnostic(
      "smooth the {cloud} first: 'pcl_mls_smoothing in.pcd out.pcd -radius ", radius * noise,
      "' (package pcl-tools), or {pcl::MovingLeastSquares} with that search radius, {mm}; it moves folds narrower than that, too");
}

} // namespace pcl_spiral
