// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Turns of a ball's centre along a path, as a machine sees them.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace pcl_spiral::test {

/** Centre of a ball of radius \p ball, mm, at a point of a path. */
inline Eigen::Vector3d
ballCentre(const ToolpathPoint& point, double ball)
{
  return point.getVector3fMap().cast<double>() + ball * point.getNormalVector3fMap().cast<double>();
}

/** How often the centre turns by more than \p degrees from one move to the next, at moves of any length; not over lifts of the tool. */
inline std::size_t
ballTurns(const pcl::PointCloud<ToolpathPoint>& path, double ball, double degrees = 150.0)
{
  constexpr double rounding = 2e-5; // mm, of places in single precision
  const double cosine = std::cos(degrees * M_PI / 180.0);
  std::size_t count = 0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d move = ballCentre(path[i], ball) - ballCentre(path[i - 1], ball);
    if (!(path[i].arc_length > path[i - 1].arc_length))
      before.setZero();
    else if (move.norm() > rounding) {
      count += move.dot(before) < cosine * move.norm() * before.norm();
      before = move;
    }
  }
  return count;
}

} // namespace pcl_spiral::test
