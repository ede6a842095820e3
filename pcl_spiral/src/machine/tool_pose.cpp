// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral {

Eigen::Vector3d
arcBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t)
{
  const double angle = angleBetween(a, b), sine = std::sin(angle);
  if (angle < 1e-6)
    return (a + t * (b - a)).normalized();
  if (sine < 1e-9)
    return a;
  return ((std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / sine).normalized();
}

ToolPose
between(const ToolPose& a, const ToolPose& b, double t)
{
  return {a.tip + t * (b.tip - a.tip), arcBetween(a.axis, b.axis, t), a.contact + t * (b.contact - a.contact),
          arcBetween(a.normal, b.normal, t)};
}

} // namespace pcl_spiral
