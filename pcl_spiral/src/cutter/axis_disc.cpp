// SPDX-License-Identifier: BSD-3-Clause
#include "axis_disc.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

AxisDisc::AxisDisc(double most, int rings) : spacing_(most / rings)
{
  for (int x = -rings; x <= rings; ++x)
    for (int y = -rings; y <= rings; ++y)
      if (x * x + y * y <= rings * rings)
        turns_.emplace_back(spacing_ * x, spacing_ * y);
  std::stable_sort(turns_.begin(), turns_.end(),
                   [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.squaredNorm() < b.squaredNorm(); });
}

std::size_t
AxisDisc::nearest(const Eigen::Vector2d& turn) const
{
  const auto nearer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return (a - turn).norm() < (b - turn).norm(); };
  return static_cast<std::size_t>(std::min_element(turns_.begin(), turns_.end(), nearer) - turns_.begin());
}

AxisWithSides::AxisWithSides(const Eigen::Vector3d& axis) : axis(axis)
{
  tangentFrame(axis, e1, e2);
}

AxisWithSides
AxisWithSides::movedTo(const Eigen::Vector3d& next) const
{
  AxisWithSides moved = *this;
  moved.axis = next;
  moved.e1 = Eigen::Quaterniond::FromTwoVectors(axis, next) * e1;
  moved.e1 = (moved.e1 - next * next.dot(moved.e1)).normalized();
  moved.e2 = next.cross(moved.e1);
  return moved;
}

Eigen::Vector3d
AxisWithSides::turned(const Eigen::Vector2d& turn) const
{
  const double angle = turn.norm();
  if (angle == 0.0)
    return axis;
  return std::cos(angle) * axis + std::sin(angle) / angle * (turn.x() * e1 + turn.y() * e2);
}

} // namespace pcl_spiral
