// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a thinned scan still shows the surface.
 */
#pragma once

#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** How far the surface lies beside the points that thinning left out. */
struct ThinningError {
  double distance = 0.0;                           ///< mm; 99 of 100 places are nearer
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< where it is that far, mm
};

/** Compares \p surface with the points that thinning left out. They are averaged in cubes of three thinning edges, so that noise
 *  cancels; three standard errors of the mean are taken off. */
ThinningError thinningError(const Surface& surface);

/** Refuses \p surface if it lies farther than \p allowed, mm, beside the points that thinning left out, and farther than the noise of a
 *  single point. */
Status checkThinning(const Surface& surface, double allowed);

} // namespace pcl_spiral
