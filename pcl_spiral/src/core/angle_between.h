// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The angle between two directions. Private.
 */
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral {

/** The angle between \p a and \p b, radians, accurate also where it is small or almost half a turn. */
inline double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace pcl_spiral
