// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Random places and directions.
 */
#pragma once

#include "support/sampling.h"

#include <Eigen/Core>

namespace pcl_spiral::test {

/** Uniform in a cube, up to \p reach in each coordinate. */
inline Eigen::Vector3d
randomVector(Random& random, double reach)
{
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/** Uniform on the unit sphere. */
inline Eigen::Vector3d
randomUnit(Random& random)
{
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

} // namespace pcl_spiral::test
