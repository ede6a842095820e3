// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Geodesics of exact surfaces, by integration of their equation.
 */
#pragma once

#include "support/surfaces.h"

namespace pcl_spiral::test {

/** A geodesic as a fine polyline. */
struct ExactGeodesic {
  Polyline points;
  double length = 0.0;
  double miss = 0.0; ///< distance from the target, mm
};

/** The geodesic from \p from to \p to that starts near the direction \p towards: x'' = -(x' H x') grad F / |grad F|^2
 *  by Runge-Kutta steps, direction and length found by shooting. */
ExactGeodesic exactGeodesic(const AnalyticSurface& surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                            const Eigen::Vector3d& towards, double length_guess);

/** Largest distance of the points of \p line from the curve, measured along the surface: across its normal. */
double sidewaysDistance(const AnalyticSurface& surface, const Polyline& line, const Polyline& curve);

/** Point of the spheroid of semi-axes (a, a, b) at a geodetic latitude and a longitude in degrees. */
Eigen::Vector3d onSpheroid(double a, double b, double latitude, double longitude);

} // namespace pcl_spiral::test
