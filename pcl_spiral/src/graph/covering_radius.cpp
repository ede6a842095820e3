// SPDX-License-Identifier: BSD-3-Clause
#include "graph/covering_radius.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

double
coveringRadiusOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a;
  if (u.dot(v) <= 0.0 || u.dot(u - v) <= 0.0 || v.dot(v - u) <= 0.0)
    return 0.5 * std::sqrt(std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()}));
  return u.norm() * v.norm() * (u - v).norm() / (2.0 * u.cross(v).norm());
}

} // namespace pcl_spiral
