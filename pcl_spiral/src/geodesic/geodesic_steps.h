// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One step of a line towards its geodesic.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <vector>

namespace pcl_spiral {

/** Moves of all points, zero at the ends, by a Newton step on the length among sideways moves x b (b = n x t):
 *    (1/g + 1/f - K w) x_i - x_{i-1}/g - x_{i+1}/f = sideways turn at i,
 *  with the segments f before and g after, w = (f + g) / 2, K the Gauss curvature, kept below 0.8 (pi / L)^2 so that
 *  the matrix is positive definite. The turn of the chords is compared with what a geodesic's own bending gives them
 *  (Numerov), which makes it exact to the fourth order. Points evenly spaced, all different.
 */
Polyline tridiagonalStep(const Polyline& points, const std::vector<SurfaceFoot>& feet);

/** Moves of all points by a Newton step on Q = |M p|^2 / 2, M = (I - N N^T) K with K the second differences over the
 *  true spacings, M frozen (Wu et al. 2025, equations 2-7), by preconditioned conjugate gradients; zero at the
 *  ends. */
Polyline conjugateGradientStep(const Polyline& points, const std::vector<SurfaceFoot>& feet);

} // namespace pcl_spiral
