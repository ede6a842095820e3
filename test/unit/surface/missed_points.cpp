// SPDX-License-Identifier: BSD-3-Clause
// Points that stand out of the fitted surface, at the edge of a step too low for the scan: a warning names the highest.
#include "support/sampling.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace missed_points_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double plateau_radius = 9.0;

/** A disc of radius 20 with a round plateau in the middle, \p high above it. */
std::vector<Vector3d>
plateau(double high, double spacing, double noise)
{
  test::Random random(3);
  std::vector<Vector3d> points;
  const int half = static_cast<int>(20.0 / spacing);
  for (int i = -half; i <= half; ++i)
    for (int k = -half; k <= half; ++k) {
      const double x = spacing * (i + random.uniform(-0.3, 0.3)), y = spacing * (k + random.uniform(-0.3, 0.3)), r = std::hypot(x, y);
      if (r < 20.0)
        points.emplace_back(x, y, (r < plateau_radius ? high : 0.0) + noise * random.normal());
    }
  return points;
}

struct Made {
  Status status;
  Path path;
  std::string warnings;
};

Made
run(const std::vector<Vector3d>& points)
{
  Made result;
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(test::toCloud(points));
  spiral.setToolRadius(4.0);
  spiral.setScallopHeight(0.1);
  spiral.compute(result.path);
  result.status = spiral.getStatus();
  for (const pcl_spiral::Diagnostic& warning : spiral.getReport().warnings)
    result.warnings += warning.text() + "\n";
  return result;
}

TEST(MissedPoints, TheEdgeOfALowStepIsNamed)
{
  constexpr double spacing = 0.8;
  for (const double spacings : {1.0, 1.2, 1.5}) {
    SCOPED_TRACE(spacings);
    const Made made = run(plateau(spacings * spacing, spacing, 0.01));
    ASSERT_TRUE(made.status.ok()) << made.status.message();
    const std::size_t begin = made.warnings.find("points of the scan stand up to ");
    ASSERT_NE(begin, std::string::npos) << made.warnings;
    double height = 0.0, x = 0.0, y = 0.0, z = 0.0;
    ASSERT_EQ(std::sscanf(made.warnings.c_str() + begin,
                          "points of the scan stand up to %lf mm over the fitted surface, the most at (%lf, %lf, %lf)", &height, &x, &y,
                          &z),
              4);
    EXPECT_GT(height, 0.2 * spacing);
    EXPECT_LT(height, 0.6 * spacings * spacing) << "a smooth fit passes near the middle of the step";
    EXPECT_NEAR(std::hypot(x, y), plateau_radius, spacing);
    EXPECT_NEAR(z, spacings * spacing, 0.05) << "the upper edge";
  }
}

TEST(MissedPoints, AnEdgeInNoiseIsNamed)
{
  constexpr double spacing = 0.8, noise = 0.12; // its points stand out of the fit by three standard deviations, none by six
  for (const double spacings : {1.3, 1.5}) {
    SCOPED_TRACE(spacings);
    const Made made = run(plateau(spacings * spacing, spacing, noise));
    ASSERT_TRUE(made.status.ok()) << made.status.message();
    const std::size_t begin = made.warnings.find(" of the scan stand up to ");
    ASSERT_NE(begin, std::string::npos) << made.warnings;
    double height = 0.0, x = 0.0, y = 0.0, z = 0.0;
    ASSERT_EQ(std::sscanf(made.warnings.c_str() + begin,
                          " of the scan stand up to %lf mm over the fitted surface, the most at (%lf, %lf, %lf)", &height, &x, &y, &z),
              4);
    EXPECT_NEAR(std::hypot(x, y), plateau_radius, 2.0 * spacing);
  }
}

TEST(MissedPoints, SinglePointsThatAreLeftOutCountUnlessTheyAreHigh)
{
  std::vector<Vector3d> points = plateau(0.0, 0.8, 0.01);
  for (int k = 0; k < 5; ++k)
    points.emplace_back(-12.0 + 6.0 * k, 0.1, 0.3 + 0.05 * k);
  points.emplace_back(0.0, 9.0, 5.0); // a false echo
  points.emplace_back(0.0, -9.0, -0.5);
  const Made made = run(points);
  ASSERT_TRUE(made.status.ok()) << made.status.message();
  EXPECT_NE(made.warnings.find("isolated"), std::string::npos) << made.warnings;
  double height = 0.0, x = 0.0, y = 0.0, z = 0.0;
  const std::size_t begin = made.warnings.find("5 points of the scan stand up to ");
  ASSERT_NE(begin, std::string::npos) << made.warnings;
  ASSERT_EQ(std::sscanf(made.warnings.c_str() + begin,
                        "5 points of the scan stand up to %lf mm over the fitted surface, the most at (%lf, %lf, %lf)", &height, &x, &y,
                        &z),
            4);
  EXPECT_NEAR(height, 0.5, 0.03);
  EXPECT_NEAR((Vector3d(x, y, z) - Vector3d(12.0, 0.1, 0.5)).norm(), 0.0, 0.01);
}

TEST(MissedPoints, ADenserScanShowsThatStepAsTheEndOfAPart)
{
  const Made made = run(plateau(1.6, 0.4, 0.01));
  EXPECT_NE(made.status.message().find("separate parts"), std::string::npos) << made.status.message();
}

TEST(MissedPoints, NoiseIsNoEdge)
{
  for (const double noise : {0.0, 0.02, 0.08}) {
    const Made made = run(plateau(0.0, 0.8, noise));
    ASSERT_TRUE(made.status.ok()) << made.status.message();
    EXPECT_EQ(made.warnings.find("over the fitted surface"), std::string::npos) << noise << ": " << made.warnings;
  }
}

} // namespace

} // namespace missed_points_test
