/** \file
 *  The centre of a surface with one boundary.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/surface/mls_surface.h>

#include <optional>

namespace pcl_spiral {

/** The geodesic Chebyshev centre: the point whose largest distance along the surface to the rim is smallest, which makes
 *  the fewest turns. Each round lays the rim out in the tangent plane by distance and direction (the log map) and moves
 *  to the centre of its smallest enclosing circle. \p rim is closed. Empty when no point of the surface is reached. */
std::optional<Eigen::Vector3d>
chebyshevCentre(const MlsSurface& surface, const Polyline& rim);

/** The point farthest from every boundary: always well inside, also on outlines like an L. */
std::optional<Eigen::Vector3d>
deepestPoint(const MlsSurface& surface, const Polyline& rim);

} // namespace pcl_spiral
