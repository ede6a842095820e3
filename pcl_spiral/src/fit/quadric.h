// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A point's foot on a quadric. Private.
 */
#pragma once

#include <pcl_spiral/fit/impl/mls_surface.h>

namespace pcl_spiral {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/** Move \p foot from the origin, where it is, to the nearest point of b0 + b1 u + b2 v + b3 u^2 + b4 u v + b5 v^2
 *  along \p up over the plane of \p e1 and \p e2, and set its normal and curvatures. u, v and the height are lengths
 *  divided by \p radius. False if that point lies outside the radius. */
bool standOnQuadric(const Vector6d& b, double radius, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2, const Eigen::Vector3d& up,
                    SurfaceFoot& foot);

} // namespace pcl_spiral
