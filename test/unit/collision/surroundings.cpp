// SPDX-License-Identifier: BSD-3-Clause
// By default all of a scan that is not the part is in the way of the ball: a path is refused, with the place, or touches nothing.
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace surroundings_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using P = pcl::PointXYZ;
using Cloud = pcl::PointCloud<P>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double ball = 5.0, spacing = 0.8, tolerance = 0.03; // mm

/** Points (u, v) of a jittered grid within half the \p width and \p height, put at \p place(u, v). */
template <typename Place>
void
addSheet(double width, double height, Place place, Cloud& cloud)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.25 * spacing, 0.25 * spacing);
  for (double u = -0.5 * width; u <= 0.5 * width; u += spacing)
    for (double v = -0.5 * height; v <= 0.5 * height; v += spacing) {
      const Vector3d p = place(u + jitter(random), v + jitter(random));
      if (p.allFinite())
        cloud.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
}

/** A round plate, 60 mm across, that bulges. */
Cloud::Ptr
plate()
{
  const Cloud::Ptr cloud(new Cloud);
  addSheet(
      60.0, 60.0,
      [](double x, double y) { return std::hypot(x, y) < 30.0 ? Vector3d(x, y, -0.002 * (x * x + y * y)) : Vector3d::Constant(NAN); },
      *cloud);
  return cloud;
}

/** A wall of 24 by 30 mm, \p gap beyond the rim of the plate. */
void
addWall(double gap, Cloud& cloud)
{
  addSheet(
      24.0, 30.0, [&](double u, double v) { return Vector3d(30.0 + gap, u, v + 13.0); }, cloud);
}

/** How deep the ball is in the deepest of \p points, by brute force along the moves of \p path. */
double
deepest(const Path& path, const std::vector<Vector3d>& points)
{
  double nearest = ball;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (int k = 0; k < 2; ++k) {
      const auto centre = [&](std::size_t j) {
        return Vector3d((path[j].getVector3fMap() + static_cast<float>(ball) * path[j].getNormalVector3fMap()).cast<double>());
      };
      const Vector3d c = centre(i) + 0.5 * k * (centre(i + 1) - centre(i));
      for (const Vector3d& p : points)
        nearest = std::min(nearest, (c - p).norm());
    }
  return ball - nearest;
}

class Spiral {
public:
  SpiralToolpathGenerator<P> generator;
  Path path;

  explicit Spiral(const Cloud::Ptr& scan)
  {
    generator.setInputCloud(scan);
    generator.setToolRadius(ball);
    generator.setScallopHeight(0.1);
  }
  const Status& run()
  {
    generator.compute(path);
    return generator.getStatus();
  }
};

std::vector<Vector3d>
pointsFrom(const Cloud& cloud, std::size_t first)
{
  std::vector<Vector3d> points;
  for (std::size_t i = first; i < cloud.size(); ++i)
    points.push_back(cloud[i].getVector3fMap().cast<double>());
  return points;
}

Prism
square(double x, double y, double half)
{
  return Prism({{x - half, y - half, 0.0}, {x + half, y - half, 0.0}, {x + half, y + half, 0.0}, {x - half, y + half, 0.0}},
               Vector3d::UnitZ());
}

} // namespace

TEST(Surroundings, TheOracleSeesABallInTheWall)
{
  const Cloud::Ptr scan = plate();
  const std::size_t own = scan->size();
  Cloud both = *scan;
  addWall(3.5, both);
  Spiral spiral(scan); // that knows nothing of the wall
  ASSERT_TRUE(spiral.run().ok());
  EXPECT_GT(deepest(spiral.path, pointsFrom(both, own)), 1.0);
}

TEST(Surroundings, AnotherPartBesideTheOneThatIsCutStandsInTheWay)
{
  for (const double gap : {3.5, 30.0}) {
    const Cloud::Ptr scan = plate();
    const std::size_t own = scan->size();
    addWall(gap, *scan);
    Spiral spiral(scan);
    spiral.generator.setPartAt({0.0, 0.0, 0.0});
    const Status& status = spiral.run();
    if (gap > 10.0) {
      ASSERT_TRUE(status.ok()) << status.message();
      EXPECT_LT(deepest(spiral.path, pointsFrom(*scan, own)), tolerance);
      continue;
    }
    EXPECT_EQ(status.code(), StatusCode::Failed) << status.message();
    EXPECT_NE(status.message().find(" mm into the scan at (33.5, "), std::string::npos) << status.message();
    ASSERT_TRUE(spiral.generator.getReport().blocked_way);
    EXPECT_EQ(spiral.generator.getReport().blocked_way->by, BlockedBy::Beside);
    EXPECT_TRUE(spiral.path.empty());
  }
}

TEST(Surroundings, WhatTheIndicesLeaveOutStandsInTheWay)
{
  for (const double gap : {3.5, 30.0}) {
    const Cloud::Ptr scan = plate();
    const auto own = static_cast<pcl::index_t>(scan->size());
    addWall(gap, *scan);
    const pcl::IndicesPtr part(new pcl::Indices);
    for (pcl::index_t i = 0; i < own; ++i)
      part->push_back(i);
    Spiral spiral(scan);
    spiral.generator.setIndices(part);
    const Status& status = spiral.run();
    EXPECT_EQ(status.ok(), gap > 10.0) << status.message();
    if (status.ok())
      EXPECT_LT(deepest(spiral.path, pointsFrom(*scan, static_cast<std::size_t>(own))), tolerance);
    else
      EXPECT_NE(status.message().find("beside what is cut"), std::string::npos) << status.message();
  }
}

TEST(Surroundings, AHoleInWhichTheScanShowsSomethingIsNoGap)
{
  // A block of 5 mm, which the scanner saw from above, on the plate; points near it are no part of it.
  const Cloud::Ptr scan = plate();
  const auto on_plate = static_cast<pcl::index_t>(scan->size());
  addSheet(
      5.0, 5.0, [](double u, double v) { return Vector3d(4.0 + u, v, 6.0); }, *scan);
  const pcl::IndicesPtr part(new pcl::Indices);
  for (pcl::index_t i = 0; i < on_plate; ++i)
    if (const P& p = (*scan)[static_cast<std::size_t>(i)]; std::max(std::abs(p.x - 4.0f), std::abs(p.y)) > 2.5f + 6.5f)
      part->push_back(i);
  Spiral spiral(scan);
  spiral.generator.setIndices(part);
  spiral.generator.setTiltAngle(0.0);
  const Status& status = spiral.run();
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(std::count_if(spiral.path.begin(), spiral.path.end(), [](const ToolpathPoint& p) { return std::hypot(p.x - 4.0, p.y) < 7.0; }),
            0);
  EXPECT_LT(deepest(spiral.path, pointsFrom(*scan, static_cast<std::size_t>(on_plate))), tolerance);
}

TEST(Surroundings, TheKeepOutsOfARegionAreKept)
{
  const Cloud::Ptr scan = plate();
  const Prism clamp = square(6.0, -3.0, 4.0);
  PartRegion<P> region;
  region.setInputCloud(scan);
  region.setToolRadius(ball);
  region.setMargin(spacing);
  region.addKeepOut(clamp);
  Cloud bare;
  region.filter(bare);
  EXPECT_EQ(region.getStatus().code(), StatusCode::InvalidArgument) << "a cloud does not carry the keep-out on";
  EXPECT_NE(region.getStatus().message().find("pcl::Indices"), std::string::npos);
  EXPECT_TRUE(bare.empty());
  const pcl::IndicesPtr part(new pcl::Indices);
  region.filter(*part);
  ASSERT_TRUE(region.getStatus().ok()) << region.getStatus().message();
  for (const bool told : {false, true}) {
    Spiral spiral(scan);
    spiral.generator.setIndices(part);
    Surroundings around;
    around.keep_outs = region.getKeepOuts();
    if (told)
      spiral.generator.setSurroundings(around);
    const Status& status = spiral.run();
    ASSERT_TRUE(status.ok()) << status.message();
    double nearest = 1e30;
    for (const ToolpathPoint& p : spiral.path)
      nearest =
          std::min(nearest, clamp.distance((p.getVector3fMap() + static_cast<float>(ball) * p.getNormalVector3fMap()).cast<double>()));
    EXPECT_GT(nearest, ball - tolerance) << "told of the keep-out: " << told;
  }
}

TEST(Surroundings, ABallInAKeepOutIsRefusedWithThePlaceAndARemedyThatWorks)
{
  const Cloud::Ptr scan = plate();
  Spiral spiral(scan);
  Surroundings around;
  around.keep_outs = {square(0.0, 10.0, 2.0)};
  spiral.generator.setSurroundings(around);
  const Status& status = spiral.run();
  EXPECT_EQ(status.code(), StatusCode::InvalidInput);
  EXPECT_NE(status.message().find("PartRegion gives the indices"), std::string::npos) << status.message();
  EXPECT_NE(status.message().find("the ball enters a keep-out by 5 mm at ("), std::string::npos) << status.message();
  ASSERT_TRUE(spiral.generator.getReport().blocked_way);
  EXPECT_EQ(spiral.generator.getReport().blocked_way->by, BlockedBy::KeepOut);
  EXPECT_TRUE(spiral.generator.getReport().blocked_way->crosses);
  PartRegion<P> region; // the remedy
  region.setInputCloud(scan);
  region.setToolRadius(ball);
  region.setMargin(spacing);
  region.addKeepOut(around.keep_outs.front());
  const pcl::IndicesPtr part(new pcl::Indices);
  region.filter(*part);
  spiral.generator.setIndices(part);
  EXPECT_TRUE(spiral.run().ok()) << spiral.run().message();
}

TEST(Surroundings, WhatTheUserGivesIsNoFalseEcho)
{
  const Cloud::Ptr scan = plate();
  Cloud wall;
  addWall(3.5, wall);
  Surroundings around;
  for (const P& p : wall)
    around.beside.push_back(p.getVector3fMap());
  const pcl::IndicesPtr all(new pcl::Indices(scan->size()));
  for (std::size_t i = 0; i < all->size(); ++i)
    (*all)[i] = static_cast<pcl::index_t>(i);
  for (const bool by_indices : {false, true})
    for (const bool with_scan : {false, true}) {
      Spiral spiral(scan);
      if (by_indices)
        spiral.generator.setIndices(all);
      around.scan = with_scan ? scan : nullptr;
      spiral.generator.setSurroundings(around);
      EXPECT_EQ(spiral.run().code(), StatusCode::Failed) << by_indices << with_scan << ": " << spiral.run().message();
    }
}

TEST(Surroundings, ASelectionOfAnEvenScanIsNoObstacle)
{
  // Half of the points of a plate with heavy tails of noise: the others lie on the same surface.
  const Cloud::Ptr scan = plate();
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 0.02);
  const pcl::IndicesPtr half(new pcl::Indices);
  for (std::size_t i = 0; i < scan->size(); ++i) {
    (*scan)[i].z += static_cast<float>((i % 50 == 1 ? 4.0 : 1.0) * noise(random));
    if (i % 2 == 0)
      half->push_back(static_cast<pcl::index_t>(i));
  }
  Spiral spiral(scan);
  spiral.generator.setIndices(half);
  EXPECT_TRUE(spiral.run().ok()) << spiral.run().message();
}

TEST(Surroundings, AnEchoOrATableAtAGapLeaveItAGap)
{
  // A gap that alone is bridged; then with an echo over it, with a table far below, and with a block in it.
  const Cloud::Ptr whole = plate();
  const auto with = [&](const std::vector<Vector3d>& others) {
    const Cloud::Ptr scan(new Cloud);
    const pcl::IndicesPtr part(new pcl::Indices);
    for (const P& p : *whole)
      if (std::hypot(p.x - 5.0, p.y) > 3.2)
        scan->push_back(p);
    for (std::size_t i = 0; i < scan->size(); ++i)
      part->push_back(static_cast<pcl::index_t>(i));
    for (const Vector3d& p : others)
      scan->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    Spiral spiral(scan);
    spiral.generator.setIndices(part);
    spiral.generator.setTiltAngle(0.0);
    EXPECT_TRUE(spiral.run().ok()) << spiral.run().message();
    const auto& warnings = spiral.generator.getReport().warnings;
    const bool is_hole = std::any_of(warnings.begin(), warnings.end(), [](const pcl_spiral::Diagnostic& text) {
      return text.text().find("is a hole that is not cut") != std::string::npos;
    });
    const auto over = std::count_if(spiral.path.begin(), spiral.path.end(), [](const ToolpathPoint& p) { return p.over_gap != 0; });
    EXPECT_EQ(is_hole, over == 0);
    return is_hole;
  };
  EXPECT_FALSE(with({}));
  EXPECT_FALSE(with({{5.0, 0.0, 9.0}}));
  std::vector<Vector3d> table, block;
  for (double x = 3.0; x <= 7.0; x += 0.5)
    for (double y = -1.5; y <= 1.5; y += 0.5) {
      table.emplace_back(x, y, -50.0);
      if (std::hypot(x - 5.0, y) < 1.0)
        block.emplace_back(x, y, -0.5);
    }
  EXPECT_FALSE(with(table));
  EXPECT_TRUE(with(block));
}

TEST(Surroundings, ASurfaceOfASelectionAloneIsWarnedOf)
{
  const Cloud::Ptr scan = plate();
  const auto own = static_cast<pcl::index_t>(scan->size());
  addWall(3.5, *scan);
  const pcl::IndicesPtr part(new pcl::Indices);
  for (pcl::index_t i = 0; i < own; ++i)
    part->push_back(i);
  ScannedSurface<P> scanned;
  scanned.setInputCloud(scan);
  scanned.setIndices(part);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  ASSERT_TRUE(surface);
  SpiralToolpathGenerator<P> alone;
  alone.setInputSurface(surface);
  alone.setToolRadius(ball);
  alone.setScallopHeight(0.1);
  Path path;
  alone.compute(path);
  ASSERT_TRUE(alone.getStatus().ok()) << alone.getStatus().message();
  const auto& warnings = alone.getReport().warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const pcl_spiral::Diagnostic& text) {
    return text.text().find("the ball may cut into it") != std::string::npos;
  }));
  Spiral with_cloud(scan); // the remedy
  with_cloud.generator.setIndices(part);
  with_cloud.generator.setInputSurface(surface);
  EXPECT_EQ(with_cloud.run().code(), StatusCode::Failed) << with_cloud.run().message();
  Cloud::Ptr other = plate();
  scanned.setInputCloud(other);
  scanned.setIndices(pcl::IndicesPtr());
  scanned.compute(surface);
  with_cloud.generator.setInputSurface(surface); // of another scan: the wall beside the first is not there
  EXPECT_TRUE(with_cloud.run().ok()) << with_cloud.run().message();
}

TEST(Surroundings, APolygonWithoutAreaIsRefused)
{
  Spiral spiral(plate());
  Surroundings around;
  around.keep_outs = {Prism({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, Vector3d::UnitZ())};
  spiral.generator.setSurroundings(around);
  EXPECT_EQ(spiral.run().code(), StatusCode::InvalidArgument) << spiral.run().message();
}

} // namespace surroundings_test
