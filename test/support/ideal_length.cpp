// SPDX-License-Identifier: BSD-3-Clause
#include "support/ideal_length.h"

#include "support/checked_path.h"

#include <Eigen/Geometry>

namespace pcl_spiral::test {

double
lengthOverLatitudes(const AnalyticSurface& surface, double radius, double scallop)
{
  return surface.region().integrate([&](const Eigen::Vector2d& u) {
    const Eigen::Vector3d x = surface.lift(u), n = surface.normal(x);
    const Eigen::Vector3d around(-x.y(), x.x(), 0.0);
    const double kappa = surface.normalCurvature(x, n.cross(around));
    return surface.areaElement(u) / exactStepOver(radius, scallop, kappa);
  });
}

} // namespace pcl_spiral::test
