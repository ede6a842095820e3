// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Error of the published normal of a ridge. Private to visualization.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_surface.h>

#include <vector>

namespace pcl_spiral {

/** Angle between the published normal, RidgeNormals::InNormalPlane, and the true one, degrees. */
double normalError(const RidgeSurface& ridge, double u, double v);

/** These angles on a grid: for equal places of the generator, the smallest and the largest along the rail. */
struct NormalErrors {
  std::vector<double> places, least, most; ///< mm, degrees
  double largest = 0.0, u = 0.0, v = 0.0;  ///< of all, and its place
};

NormalErrors normalErrors(const RidgeSurface& ridge);

} // namespace pcl_spiral
