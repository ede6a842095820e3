// SPDX-License-Identifier: BSD-3-Clause
// The closing of a scan by a ball: against brute force on a finer grid, grooves and steps known exactly, and meshes without handles.
#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include "graph/grid_triangles.h"
#include "support/range_view.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace ball_closing_test {

namespace {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::Vector3d;

constexpr double radius = 5.0, spacing = 0.5; // mm
constexpr double sag = 0.025;                 // the ball hangs between points up to 0.92 mm apart: 0.46^2 / (2 radius), and rounding

/** z = \p height(x, y) on a jittered grid over 40 by 30 mm. */
template <typename Height>
Cloud::Ptr
scanOf(const Height& height, unsigned int seed = 3)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.15 * spacing, 0.15 * spacing);
  const auto cloud = pcl::make_shared<Cloud>();
  for (double x = -20.0; x <= 20.0; x += spacing)
    for (double y = -15.0; y <= 15.0; y += spacing) {
      const double u = x + jitter(random), v = y + jitter(random);
      cloud->push_back(pcl::PointXYZ(static_cast<float>(u), static_cast<float>(v), static_cast<float>(height(u, v))));
    }
  return cloud;
}

Cloud
closed(const Cloud::ConstPtr& scan, BallClosing<pcl::PointXYZ>& closing)
{
  closing.setInputCloud(scan);
  closing.setToolRadius(radius);
  closing.setQuiet(true);
  Cloud points;
  closing.compute(points);
  return points;
}

/** Height of the first of \p scan that a ball over (u, v) meets, by looking at all. */
double
dropped(const Cloud& scan, double u, double v)
{
  double highest = -std::numeric_limits<double>::infinity();
  for (const pcl::PointXYZ& p : scan) {
    const double off = (p.x - u) * (p.x - u) + (p.y - v) * (p.y - v);
    if (off <= radius * radius)
      highest = std::max(highest, p.z + std::sqrt(radius * radius - off));
  }
  return highest;
}

} // namespace

TEST(BallClosing, DropsTheBallAsBruteForceDoes)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-20.0, 20.0), height(-8.0, 8.0);
  std::vector<Vector3d> points;
  for (int i = 0; i < 3000; ++i)
    points.emplace_back(place(random), place(random), height(random));
  const DropBall ball(points, radius);
  for (const double depth : {0.0, 0.3})
    for (int k = 0; k < 400; ++k) {
      const double u = 1.4 * place(random), v = 1.4 * place(random), r = radius - depth;
      double expected = -std::numeric_limits<double>::infinity();
      for (const Vector3d& p : points)
        if (const double off = (p.head<2>() - Eigen::Vector2d(u, v)).squaredNorm(); off <= r * r)
          expected = std::max(expected, p.z() + std::sqrt(r * r - off));
      EXPECT_DOUBLE_EQ(expected, ball.height(u, v, depth)) << u << ' ' << v;
    }
}

TEST(BallClosing, IsTheLowestSurfaceThatTheBallTouches)
{
  const auto scan =
      scanOf([](double x, double y) { return 1.2 * std::sin(0.6 * x) + 0.8 * std::cos(0.7 * y); }); // hollows of 2.3 mm radius
  BallClosing<pcl::PointXYZ> closing;
  const Cloud points = closed(scan, closing);
  ASSERT_TRUE(closing.getStatus().ok()) << closing.getStatus().message();
  ASSERT_GT(points.size(), 5000u);
  double worst = 0.0;
  int looked_at = 0;
  for (std::size_t i = 0; i < points.size(); i += 97) {
    const pcl::PointXYZ& p = points[i];
    if (std::abs(p.x) > 12.0 || std::abs(p.y) > 8.0)
      continue; // centres over the rim are of the grid alone
    double lowest = std::numeric_limits<double>::infinity();
    for (double u = -radius; u <= radius; u += 0.1)
      for (double v = -radius; v <= radius; v += 0.1)
        if (const double rest = radius * radius - u * u - v * v; rest >= 0.0)
          lowest = std::min(lowest, dropped(*scan, p.x + u, p.y + v) - std::sqrt(rest));
    EXPECT_GE(p.z, lowest - 0.02); // the centres looked at are others
    worst = std::max(worst, std::abs(p.z - lowest));
    ++looked_at;
  }
  EXPECT_GT(looked_at, 10);
  EXPECT_LT(worst, 0.06); // a cell is 0.2 mm
  EXPECT_GT(closing.getReport().covered, 100u);
}

TEST(BallClosing, LeavesWhatTheBallReachesAsItIs)
{
  BallClosing<pcl::PointXYZ> closing;
  const auto dome = [](double x, double y) { return std::sqrt(60.0 * 60.0 - x * x - y * y); };
  for (const pcl::PointXYZ& p : closed(scanOf(dome), closing))
    if (std::abs(p.x) < 19.0 && std::abs(p.y) < 14.0) { // the rim is ragged
      EXPECT_LT(p.z, dome(p.x, p.y) + 1e-3);
      EXPECT_GT(p.z, dome(p.x, p.y) - sag);
    }
  EXPECT_EQ(closing.getReport().covered, 0u);
  EXPECT_NEAR(closing.getReport().spacing, spacing, 0.1);
}

TEST(BallClosing, RestsInAGroove)
{
  BallClosing<pcl::PointXYZ> closing;
  const double flank = M_PI / 4.0; // the ball rests radius / cos(flank) above the bottom
  const Cloud points = closed(scanOf([](double x, double) { return std::abs(x); }), closing);
  double bottom = 1e9;
  for (const pcl::PointXYZ& p : points)
    if (std::abs(p.y) < 10.0)
      bottom = std::min(bottom, static_cast<double>(p.z));
  EXPECT_NEAR(bottom, radius / std::cos(flank) - radius, 0.05);
}

TEST(BallClosing, MakesAFlankOfAWall)
{
  BallClosing<pcl::PointXYZ> closing;
  const Cloud points = closed(scanOf([](double x, double) { return x < 0.0 ? 20.0 : 0.0; }), closing);
  const double steepest = std::tan(75.0 * M_PI / 180.0);
  ASSERT_GT(points.size(), 1000u);
  for (const pcl::PointXYZ& p : points) {
    const double x = p.x;
    if (std::abs(x) > 19.0 || std::abs(p.y) > 14.0)
      continue; // the rim is ragged
    if (x < -spacing)
      EXPECT_NEAR(p.z, 20.0, sag);
    else if (x > 20.0 / steepest + radius)
      EXPECT_NEAR(p.z, 0.0, sag);
    else
      EXPECT_GE(p.z, std::min(20.0, 20.0 - steepest * (x + spacing)) - sag) << x; // nothing below the flank
  }
}

TEST(BallClosing, DoesNotDependOnOrderThreadsOrFrame)
{
  const auto scan = test::rangeView(test::foldedPart(test::FoldedPart::Bust, 3), 0.05, 3);
  BallClosing<pcl::PointXYZ> closing;
  const Cloud once = closed(scan, closing);
  const auto shuffled = pcl::make_shared<Cloud>(*scan);
  std::shuffle(shuffled->points.begin(), shuffled->points.end(), std::mt19937(7));
  BallClosing<pcl::PointXYZ> again;
  again.setNumberOfThreads(1);
  const Cloud other = closed(shuffled, again);
  ASSERT_EQ(once.size(), other.size());
  for (std::size_t i = 0; i < once.size(); ++i)
    ASSERT_EQ(once[i].getVector3fMap(), other[i].getVector3fMap());
  EXPECT_EQ(closing.getReport().covered, again.getReport().covered);
  // Turned by quarter turns about the view, which keep the frame of the grid, the points turn with it.
  BallClosing<pcl::PointXYZ> turned;
  const auto quarter = pcl::make_shared<Cloud>(*scan);
  for (pcl::PointXYZ& p : *quarter)
    p = pcl::PointXYZ(-p.y, p.x, p.z);
  turned.setDirection(Vector3d::UnitZ());
  BallClosing<pcl::PointXYZ> straight;
  straight.setDirection(Vector3d::UnitZ());
  const double count = static_cast<double>(closed(scan, straight).size());
  EXPECT_NEAR(static_cast<double>(closed(quarter, turned).size()), count, 0.01 * count);
}

TEST(BallClosing, EveryHeightFieldIsAMeshWithoutHandles)
{
  for (unsigned int seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    HeightGrid grid;
    grid.cell = 0.3;
    grid.axes = Eigen::AngleAxisd(unit(random), Vector3d(unit(random), unit(random), 1.0).normalized()).toRotationMatrix();
    std::vector<Eigen::Vector3f> points;
    for (int column = 0; column < 40; ++column)
      for (int row = 0; row < 30; ++row)
        if (unit(random) > 0.02 * seed) // nodes are missing, and flanks are too steep
          points.push_back(grid.outside({column * grid.cell, row * grid.cell, 0.06 * seed * unit(random)}).cast<float>());
    const Triangulation mesh = gridTriangles(points, grid);
    std::set<std::uint32_t> corners;
    long open = 0;
    for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h) {
      corners.insert(mesh.origin(h));
      open += mesh.opposite(h) == Triangulation::none;
    }
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
      const auto& [a, b, c] = mesh.triangle(t);
      EXPECT_GT((points[b] - points[a]).cross(points[c] - points[a]).dot(grid.along().cast<float>()), 0.0f);
    }
    std::vector<std::size_t> parts;
    mesh.parts(parts);
    const long edges = (static_cast<long>(mesh.halfEdgeCount()) + open) / 2;
    const long euler = static_cast<long>(corners.size()) - edges + static_cast<long>(mesh.triangleCount());
    EXPECT_EQ(euler, 2 * static_cast<long>(parts.size()) - static_cast<long>(mesh.boundaryLoops().size())) << "seed " << seed;
  }
}

TEST(BallClosing, IsASurfaceOfOnePiece)
{
  for (const test::FoldedPart kind :
       {test::FoldedPart::Bust, test::FoldedPart::Hand, test::FoldedPart::Bracket, test::FoldedPart::Casting}) {
    BallClosing<pcl::PointXYZ> closing;
    const auto points = pcl::make_shared<Cloud>(closed(test::rangeView(test::foldedPart(kind, 11), 0.05, 11), closing));
    ScannedSurface<pcl::PointXYZ> surface;
    surface.setInputCloud(points);
    surface.setHeightGrid(closing.getHeightGrid());
    surface.setLargestPart(true);
    surface.setQuiet(true);
    Surface::ConstPtr made;
    surface.compute(made);
    ASSERT_TRUE(made) << surface.getStatus().message();
    EXPECT_GT(made->size(), 0.97 * static_cast<double>(points->size()));
    for (std::size_t i = 0; i < made->size(); i += 11)
      EXPECT_GT(made->normal(i).dot(closing.getHeightGrid().along()), 0.0);
    EXPECT_TRUE(made->clusters().empty());
  }
}

TEST(BallClosing, RefusesBadInput)
{
  const auto flat = scanOf([](double, double) { return 0.0; });
  const auto says = [](BallClosing<pcl::PointXYZ>& closing, const Cloud::ConstPtr& cloud, double tool, const char* words) {
    closing.setInputCloud(cloud);
    closing.setToolRadius(tool);
    closing.setQuiet(true);
    Cloud points(3, 1);
    closing.compute(points);
    EXPECT_FALSE(closing.getStatus().ok());
    EXPECT_TRUE(points.empty());
    EXPECT_NE(closing.getStatus().message().find(words), std::string::npos) << closing.getStatus().message();
  };
  const auto nan = pcl::make_shared<Cloud>();
  nan->resize(100);
  for (pcl::PointXYZ& p : *nan)
    p.x = std::numeric_limits<float>::quiet_NaN();
  const auto two = pcl::make_shared<Cloud>();
  two->push_back({0, 0, 0});
  two->push_back({9, 0, 0});
  BallClosing<pcl::PointXYZ> closing;
  says(closing, Cloud::ConstPtr(), radius, "missing or empty");
  says(closing, pcl::make_shared<Cloud>(), radius, "missing or empty");
  says(closing, nan, radius, "no point is finite");
  says(closing, two, radius, "at least 50");
  says(closing, flat, 0.0, "above 0 mm");
  says(closing, flat, std::numeric_limits<double>::quiet_NaN(), "above 0 mm");
  says(closing, flat, 0.3, "not larger than the point spacing");
  says(closing, flat, 40.0, "as wide as itself");
  const auto far = pcl::make_shared<Cloud>(*flat);
  far->push_back({1e7f, 1e7f, 0.0f});
  says(closing, far, radius, "are possible");
  closing.setDirection(Vector3d::Zero());
  says(closing, flat, radius, "direction of the tool");
}

TEST(BallClosing, EndsWhereObstaclesKeepTheBallAway)
{
  const auto plane = pcl::make_shared<Cloud>(), block = pcl::make_shared<Cloud>();
  constexpr float height = 10.0f;
  for (float x = -20.0f; x <= 10.0f; x += 0.5f)
    for (float y = -15.0f; y <= 15.0f; y += 0.5f)
      (x < 0.0f ? plane : block)->push_back({x, y, x < 0.0f ? 0.0f : height});
  BallClosing<pcl::PointXYZ> closing;
  const Cloud alone = closed(plane, closing);
  const auto most = [](const Cloud& cloud) {
    return std::max_element(cloud.begin(), cloud.end(), [](const auto& a, const auto& b) { return a.x < b.x; })->x;
  };
  EXPECT_GT(most(alone), -0.8);
  closing.setObstacles(block);
  const Cloud beside = closed(plane, closing);
  ASSERT_TRUE(closing.getStatus().ok()) << closing.getStatus().message();
  // The ball comes down beside the edge, a radius from it, then along a flank of 75 degrees.
  const double end = -radius - (height - radius) / steepest_tangent;
  EXPECT_LT(most(beside), end + 1e-4);
  EXPECT_GT(most(beside), end - 2.0 * closing.getReport().cell);
  for (const pcl::PointXYZ& p : beside)
    EXPECT_NEAR(p.z, 0.0, sag);
  EXPECT_NEAR(closing.getDropBall()->height(closing.getHeightGrid().inside({2, 0, 0}).x(), closing.getHeightGrid().inside({2, 0, 0}).y()),
              height + radius, 1e-6); // the ball over all points
}

} // namespace ball_closing_test
