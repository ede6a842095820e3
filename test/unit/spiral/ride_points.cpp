// SPDX-License-Identifier: BSD-3-Clause
// How many points a path has over places that the ball does not reach.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ride_points_test {

using namespace pcl_spiral;

TEST(RidePoints, HasNoMorePointsWherePlacesOfTheBallAreAsDeepAsTheNoise)
{
  // In grooves of a few spacings the ball rests deeper in the fitted surface than the chord error. More points would not mend that.
  const double height = 1.6, length = 8.0, spacing = 1.7, ball = 4.0;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-0.35 * spacing, 0.35 * spacing);
  for (double x = -24.0; x < 24.0; x += spacing)
    for (double y = -14.0; y < 14.0; y += spacing) {
      const double at = x + off(random), z = std::abs(at) < 1.5 * length ? -height * std::cos(2.0 * M_PI * at / length) : height;
      cloud->push_back({static_cast<float>(at), static_cast<float>(y + off(random)), static_cast<float>(z)});
    }
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setMethod(SpiralMethod::Radial);
  spiral.setToolRadius(ball);
  spiral.setScallopHeight(0.05);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  double length_of_path = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length_of_path += (path[i].getVector3fMap() - path[i - 1].getVector3fMap()).norm();
  EXPECT_GT(spiral.getReport().lifted_length, 100.0);
  EXPECT_LT(static_cast<double>(path.size()), 10.0 * length_of_path); // of mm
}

} // namespace ride_points_test
