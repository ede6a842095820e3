// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether two moves cross.
 */
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral {

/** Whether the moves from \p a to \p b and from \p c to \p d cross in the plane of both; moves that only meet do not. */
inline bool
movesCross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
  const Eigen::Vector3d n = (b - a).cross(d - c);
  const double size = n.norm();
  if (size <= 1e-12 || std::abs((c - a).dot(n)) > 0.1 * size * ((b - a).norm() + (d - c).norm()))
    return false;
  const auto side = [&n](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& x) {
    return (q - p).cross(x - p).dot(n);
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

} // namespace pcl_spiral
