// SPDX-License-Identifier: BSD-3-Clause
// The published method with SpiralToolpathGenerator: gaps marked or refused, loops given by the user, reports after a failure.
#include "support/even_cloud.h"
#include "support/given_loops.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace published_generator_test {

namespace {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;
using Loops = std::vector<BoundaryLoop>;

constexpr double sphere = 150.0, apart = 2.0;
const Eigen::Vector2d hole(25.0, 0.0);

/** Rings of points round the top, all except the rim slightly moved. */
Cloud::Ptr
dome(double hole_radius)
{
  constexpr int rings = 30;
  std::vector<Eigen::Vector3d> points;
  test::Random random(1);
  for (int k = 0; k <= rings; ++k) {
    const double r = 60.0 * k / rings, off = k < rings ? 0.1 * apart : 0.0;
    const int count = k > 0 ? static_cast<int>(2.0 * M_PI * r / apart) : 1;
    for (int i = 0; i < count; ++i) {
      const double a = 2.0 * M_PI * i / count + 0.37 * k;
      const double x = r * std::cos(a) + off * random.uniform(-1, 1), y = r * std::sin(a) + off * random.uniform(-1, 1);
      if ((Eigen::Vector2d(x, y) - hole).norm() >= hole_radius)
        points.emplace_back(x, y, std::sqrt(sphere * sphere - x * x - y * y));
    }
  }
  return test::toCloud(points);
}

SpiralToolpathGenerator<pcl::PointXYZ>
published(const Cloud::ConstPtr& cloud)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setMethod(SpiralMethod::Published);
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setChordError(0.02);
  spiral.setQuiet(true);
  spiral.setInputCloud(cloud);
  return spiral;
}

bool
warnsOf(const SpiralReport& report, const std::string& words)
{
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const pcl_spiral::Diagnostic& warning) { return warning.text().find(words) != std::string::npos; });
}

TEST(PublishedGenerator, MarksWhatLiesOverAHole)
{
  const auto cloud = dome(8.0);
  auto spiral = published(cloud);
  spiral.setBoundaryLoops(test::loopsOf(cloud));
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  std::size_t deep = 0, marked = 0;
  for (const ToolpathPoint& p : path) {
    const double off = (Eigen::Vector2d(p.x, p.y) - hole).norm();
    marked += p.over_gap;
    deep += off < 7.0;
    if (off < 7.0)
      EXPECT_EQ(p.over_gap, 1);
    if (off > 8.0 + 0.8 * apart) // the empty circle reaches the points round the hole
      EXPECT_EQ(p.over_gap, 0);
  }
  std::printf("  %zu points, %zu marked, %zu deep inside\n", path.size(), marked, deep);
  EXPECT_GT(deep, 0u);
  EXPECT_EQ(spiral.getReport().gap_points, marked);
  EXPECT_GT(spiral.getReport().gap_length, 0.0);
  EXPECT_TRUE(warnsOf(spiral.getReport(), "lie over gaps of the scan"));
}

TEST(PublishedGenerator, MarksNothingOnAWholeDome)
{
  const auto cloud = dome(0.0);
  auto spiral = published(cloud);
  spiral.setGapHandling(GapHandling::Refuse);
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  EXPECT_EQ(spiral.getReport().gap_points, 0u);
  EXPECT_FALSE(warnsOf(spiral.getReport(), "gaps of the scan"));
}

TEST(PublishedGenerator, RefusesGapsWhereAsked)
{
  for (const bool named : {true, false}) { // by its loop; by the path over it
    const auto cloud = dome(named ? 12.0 : 8.0);
    const Loops loops = test::loopsOf(cloud);
    ASSERT_EQ(loops.size(), named ? 2u : 1u);
    auto spiral = published(cloud);
    spiral.setGapHandling(GapHandling::Refuse);
    spiral.setBoundaryLoops(loops);
    Path path;
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidInput) << named;
    EXPECT_NE(spiral.getStatus().message().find("the scan has a gap at ("), std::string::npos) << spiral.getStatus().message();
    EXPECT_TRUE(path.empty());
  }
}

TEST(PublishedGenerator, KeepsToAnOutlineOfTheUsersOwn)
{
  auto spiral = published(dome(0.0));
  spiral.setBoundaryLoops({test::circleOnSphere(sphere, 35.0)});
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  double reach = 0.0, round = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    reach = std::max(reach, static_cast<double>(std::hypot(path[i].x, path[i].y)));
    if (i > 0)
      round += std::atan2(path[i - 1].x * path[i].y - path[i - 1].y * path[i].x, path[i - 1].x * path[i].x + path[i - 1].y * path[i].y);
  }
  EXPECT_NEAR(reach, 35.0, 0.5);
  EXPECT_GT(round, 0.0) << "counter-clockwise";
}

TEST(PublishedGenerator, RefusesLoopsThatCannotBe)
{
  const auto cloud = dome(0.0);
  const Loops loops = test::loopsOf(cloud);
  const auto refused = [&](const BoundaryLoop& loop, const std::string& word) {
    auto spiral = published(cloud);
    spiral.setBoundaryLoops({loop});
    Path path;
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidInput) << word;
    EXPECT_NE(spiral.getStatus().message().find(word), std::string::npos) << spiral.getStatus().message();
    EXPECT_TRUE(path.empty());
  };
  BoundaryLoop wrong = loops[0];
  std::reverse(wrong.curve.begin(), wrong.curve.end());
  wrong.corners.clear();
  refused(wrong, "on its right");
  wrong = loops[0];
  wrong.corners.push_back(100000000);
  refused(wrong, "corner 100000000");
  refused(BoundaryLoop(), "0 curve points");
}

TEST(PublishedGenerator, AFailureReportsLoopsAndWarnings)
{
  const auto exact = test::boomerangPatch();
  std::vector<Eigen::Vector3d> points = test::evenPoints(*exact, 2.0, 10.0, 6);
  const Eigen::Vector3d middle = *std::max_element(
      points.begin(), points.end(), [&](const auto& a, const auto& b) { return exact->rimDistance(a) < exact->rimDistance(b); });
  points.erase(std::remove_if(points.begin(), points.end(), [&](const auto& p) { return (p - middle).norm() < 15.0; }), points.end());
  const auto cloud = test::toCloud(points);
  auto spiral = published(cloud);
  spiral.setBoundaryLoops(test::loopsOf(cloud));
  Path path;
  spiral.compute(path);
  EXPECT_EQ(spiral.getStatus().code(), StatusCode::Failed);
  EXPECT_EQ(spiral.getReport().loops.size(), 2u);
  EXPECT_TRUE(warnsOf(spiral.getReport(), "is not bridged"));
  EXPECT_EQ(spiral.getReport().path_points, 0u);
}

} // namespace

} // namespace published_generator_test
