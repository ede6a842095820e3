// SPDX-License-Identifier: BSD-3-Clause
// How deep points are in a ball and its shank on their way, against distances from the exact cylinder.
#include "collision/ball_way.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shank_way_test {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double radius = 4.0; // mm

/** A straight path along x, \p step mm between its points, the tool upright on a plane. */
pcl::PointCloud<ToolpathPoint>
straightPath(double step)
{
  pcl::PointCloud<ToolpathPoint> path;
  for (double x = 0.0; x <= 40.0; x += step) {
    ToolpathPoint p;
    p.x = static_cast<float>(x);
    p.y = p.z = p.normal_x = p.normal_y = p.axis_x = p.axis_y = 0.0f;
    p.normal_z = p.axis_z = 1.0f;
    p.arc_length = static_cast<float>(x);
    path.push_back(p);
  }
  return path;
}

} // namespace

TEST(ShankWay, PointsInTheWallOfTheShankAreAsDeepAsTheyAre)
{
  for (const double step : {0.1, 0.37, 1.3}) {
    const pcl::PointCloud<ToolpathPoint> path = straightPath(step);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(2.0, 38.0), z(radius + 1.0, 10.0 * radius), deep(-0.3, 0.5);
    std::vector<Vector3f> points;
    std::vector<double> exact;
    for (int i = 0; i < 3000; ++i) {
      const double depth = deep(random), side = i % 2 == 0 ? 1.0 : -1.0;
      points.push_back(Vector3d(x(random), side * (radius - depth), z(random)).cast<float>());
      exact.push_back(std::max(0.0, depth));
    }
    const std::vector<double> depths = depthsInWay(path, radius, points);
    // shanks are looked at a tenth of the radius apart, also between points of the path
    const double half = 0.5 * 0.1 * radius, deepest = radius - 0.5, tolerance = std::hypot(deepest, half) - deepest + 1e-4;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(depths[i], exact[i] + 1e-4) << step << ": " << points[i].transpose();
      EXPECT_GE(depths[i], exact[i] - tolerance) << step << ": " << points[i].transpose();
    }
  }
}

TEST(ShankWay, PointsInTheWayOfTheBallAreAsDeepAsTheyAre)
{
  const pcl::PointCloud<ToolpathPoint> path = straightPath(1.7);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> x(2.0, 38.0), angle(M_PI, 2.0 * M_PI), deep(-0.3, 2.0);
  std::vector<Vector3f> points;
  std::vector<double> exact;
  for (int i = 0; i < 3000; ++i) {
    const double depth = deep(random), a = angle(random), r = radius - depth;
    points.push_back(Vector3d(x(random), r * std::cos(a), radius + r * std::sin(a)).cast<float>());
    exact.push_back(std::max(0.0, depth));
  }
  const std::vector<double> depths = depthsInWay(path, radius, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(depths[i], exact[i], 1e-4) << points[i].transpose();
}

} // namespace shank_way_test
