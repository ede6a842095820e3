// SPDX-License-Identifier: BSD-3-Clause
#include "normal_error.h"

#include <pcl_spiral/core/impl/angles.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

double
normalError(const RidgeSurface& ridge, double u, double v)
{
  const Eigen::Vector3d is = ridge.normal(u, v), published = ridge.normal(u, v, RidgeNormals::InNormalPlane);
  return angleBetween(published, is) * 180.0 / pi;
}

NormalErrors
normalErrors(const RidgeSurface& ridge)
{
  constexpr int along = 400, across = 80;
  NormalErrors result;
  for (int j = 0; j <= across; ++j) {
    const double v = ridge.generator().length() * j / across;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (int i = 0; i <= along; ++i) {
      const double u = ridge.rail().length() * i / along, off = normalError(ridge, u, v);
      least = std::min(least, off);
      most = std::max(most, off);
      if (off > result.largest) {
        result.largest = off;
        result.u = u;
        result.v = v;
      }
    }
    result.places.push_back(v);
    result.least.push_back(least);
    result.most.push_back(most);
  }
  return result;
}

} // namespace pcl_spiral
