// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Radial lines of a spiral.
 */
#pragma once

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/surface_foot.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A curve on the surface from the centre, or the inner loop, to the rim. Lengths in mm. */
struct RadialLine {
  BSplineCurve curve;            ///< arc length runs outward
  std::vector<SurfaceFoot> feet; ///< the surface at stations of equal arc length; the first and last at the ends
  double rim_share = 0.0;        ///< share of the rim's length from line 0 to this one, 0 to 1
  double turn_share = 0.0;       ///< share of each turn from line 0 to this one, 0 to 1
  bool corner = false;           ///< ends on a corner of the rim: turns keep their corner here
  int level = 0;                 ///< round in which it was added: coarse lines have level 0
  double deviation = 0.0;        ///< largest distance of the curve from the points it was fitted to
  double unsettled = 0.0;        ///< sideways move that the last iteration of a geodesic still required; 0 if it converged

  double length() const { return curve.length(); } ///< Arc length of the curve.
  /** Distance between neighbouring feet along the curve. */
  double stationSpacing() const { return length() / static_cast<double>(feet.size() - 1); }
};

/** Radial lines, in order along the rim, and the boundaries from line 0 on. */
struct RadialLineSet {
  std::vector<RadialLine> lines;                    ///< counter-clockwise along the rim
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< one boundary only
  bool harmonic = false;                            ///< the fallback made them
  Diagnostic why_harmonic;                          ///< reason of the fallback; empty without it
  Polyline rim;                                     ///< closed, from line 0's end
  std::vector<std::size_t> rim_corners;             ///< entries of rim where it turns sharply
  Polyline inner;                                   ///< closed, from line 0's start; empty with one boundary
  std::vector<std::size_t> inner_corners;           ///< entries of inner where it turns sharply
  double largest_interpolation_error = 0.0;         ///< measured between neighbouring lines, mm
  bool centre_settled = true;                       ///< the search for the centre converged
};

} // namespace pcl_spiral
