// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops to give to a stage: loops found on a cloud, and circles on a sphere.
 */
#pragma once

#include <pcl_spiral/features/boundary_loops.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pcl_spiral::test {

inline std::vector<BoundaryLoop>
loopsOf(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  BoundaryLoops<pcl::PointXYZ> boundaries;
  boundaries.setInputCloud(cloud);
  std::vector<BoundaryLoop> loops;
  boundaries.compute(loops);
  EXPECT_TRUE(boundaries.getStatus().ok()) << boundaries.getStatus().message();
  return loops;
}

/** A circle of \p radius round the top of the sphere of radius \p sphere about the origin, with the surface inside it (Outer) or
 *  outside it (Inner). */
inline BoundaryLoop
circleOnSphere(double sphere, double radius, LoopType type = LoopType::Outer)
{
  BoundaryLoop loop;
  loop.type = type;
  for (int i = 0; i < 360; ++i) {
    const double a = (type == LoopType::Outer ? 2.0 : -2.0) * M_PI * i / 360.0;
    loop.curve.emplace_back(radius * std::cos(a), radius * std::sin(a), std::sqrt(sphere * sphere - radius * radius));
  }
  loop.points = loop.curve;
  loop.length = length(loop.curve, true);
  return loop;
}

} // namespace pcl_spiral::test
