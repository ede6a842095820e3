// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One radial line of a spiral.
 */
#pragma once

#include <pcl_spiral/core/impl/bspline.h>
#include <pcl_spiral/surface/impl/mls_surface.h>

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

  double length() const { return curve.length(); }
  double stationSpacing() const { return length() / static_cast<double>(feet.size() - 1); }
};

} // namespace pcl_spiral
