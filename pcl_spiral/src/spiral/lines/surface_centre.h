// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The centre of a surface with one boundary.
 */
#pragma once

#include "start_lines.h"
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <optional>

namespace pcl_spiral {

/** A centre, and rough lines from it. */
struct SurfaceCentre {
  Eigen::Vector3d position;
  std::optional<StartLines> lines;
  bool settled = true; ///< the last round moved it by less than the limit
};

/** The point x of the surface with the least max d / sqrt(min d) of the distances d along the surface to the rim, maxima
 *  and minima taken as means of the 16th power.
 *
 *  The largest distance sets the number of turns. The place where it is least (the geodesic Chebyshev centre) may lie close
 *  to the rim or on it (a right triangle, a kidney), and turns would be squeezed there. The smallest distance prevents this.
 *  Each round maps the rim to the tangent plane by distance and direction (the log map), finds the best place there by
 *  Newton's method and moves to it. Distances are those of exact geodesics, so the centre
 *  moves with the part.
 *  \p rim is closed. Empty if no point of the surface is reached. */
std::optional<SurfaceCentre> balancedCentre(const MlsSurface& surface, const Polyline& rim);

/** The point farthest from every boundary: always well inside, even in an L-shaped outline. */
std::optional<Eigen::Vector3d> deepestPoint(const MlsSurface& surface, const Polyline& rim);

} // namespace pcl_spiral
