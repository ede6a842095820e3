// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far the published normal of a ridge is off. Private to visualization.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_surface.h>

#include <vector>

namespace pcl_spiral {

/** Angle between the published normal, RidgeNormals::InNormalPlane, and the true one, degrees. */
double normalError(const RidgeSurface& ridge, double u, double v);

/** These angles on a grid: at each of equal places of the generator the least and the most along the rail. */
struct NormalErrors {
  std::vector<double> places, least, most; ///< mm, degrees
  double largest = 0.0, u = 0.0, v = 0.0;  ///< of all, and where
};

NormalErrors normalErrors(const RidgeSurface& ridge);

} // namespace pcl_spiral
