// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Orthonormal frames.
 */
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace pcl_spiral {

/** Two unit vectors that form a right-handed frame with the unit vector \p n: (e1, e2, n).
 *  Continuous in n except at n_z = 0-. Source: Duff et al., Building an orthonormal basis, revisited, JCGT 6(1), 2017. */
inline void
tangentFrame(const Eigen::Vector3d& n, Eigen::Vector3d& e1, Eigen::Vector3d& e2)
{
  const double sign = std::copysign(1.0, n.z());
  const double a = -1.0 / (sign + n.z());
  const double b = n.x() * n.y() * a;
  e1 = Eigen::Vector3d(1.0 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  e2 = Eigen::Vector3d(b, sign + n.y() * n.y() * a, -n.y());
}

} // namespace pcl_spiral
