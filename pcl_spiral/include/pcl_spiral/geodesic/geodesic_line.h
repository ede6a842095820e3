// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A geodesic, and how it is found.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/surface_foot.h>

#include <limits>
#include <vector>

namespace pcl_spiral {

/** A curve on a surface between two fixed points, with equal spacing. Lengths in mm. */
struct GeodesicLine {
  Polyline points;               ///< the first and last are kept as given
  std::vector<SurfaceFoot> feet; ///< one per point; at the ends position is the end itself, and valid is true if the
                                 ///< surface reaches it
  double length = 0.0;           ///< of a smooth curve through the points, not of the chords
  double largest_move = std::numeric_limits<double>::infinity(); ///< sideways, required by the last iteration
  bool converged = false;                                        ///< largest_move is within the tolerance
  bool left_surface = false;                                     ///< the geodesic leaves the cloud: over a re-entrant rim or a gap
  Eigen::Vector3d left_at = Eigen::Vector3d::Zero();             ///< the first such place, if left_surface
};

/** Start of the refinement of a geodesic. */
enum class GeodesicStart {
  Field, ///< steepest descent of a distance field: on the correct side of every hill, close to the geodesic
  Graph  ///< shortest path over edges
};

/** The step that brings a line nearer to its geodesic. */
enum class RefinementMethod {
  TridiagonalNewton,      ///< sideways moves from a tridiagonal system with the Gauss curvature
  ConjugateGradientNewton ///< as published (Wu et al. 2025, equations 2-7), with fixed ends; slower
};

} // namespace pcl_spiral
