// SPDX-License-Identifier: BSD-3-Clause
// Loops given by the user: unchanged by gap bridging, refused if they belong to another scan.
#include "support/given_loops.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace given_loops_test {

namespace {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;
using Loops = std::vector<BoundaryLoop>;

constexpr double sphere = 150.0, rim = 60.0;

/** A cap of the sphere with its top at \p x, 0, and with a gap. */
Cloud::Ptr
dome(double gap_radius, double gap_x, double x = 0.0)
{
  std::vector<test::PlaneLoop> outlines{test::circle({0, 0}, rim)};
  if (gap_radius > 0.0)
    outlines.push_back(test::circle({gap_x, 0}, gap_radius));
  auto points = test::sampleUniform(*test::ball(sphere, test::Region(outlines)), 12000, 4).points;
  for (Eigen::Vector3d& p : points)
    p.x() += x;
  return test::toCloud(points);
}

SpiralToolpathGenerator<pcl::PointXYZ>
generator()
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setQuiet(true);
  return spiral;
}

struct Reach {
  double least = 1e9, largest = 0.0;
};

/** Distances of a path from the axis of the dome. */
Reach
reachOf(const Path& path)
{
  Reach reach;
  for (const ToolpathPoint& p : path) {
    const double r = std::hypot(p.x, p.y);
    reach.least = std::min(reach.least, r);
    reach.largest = std::max(reach.largest, r);
  }
  return reach;
}

/** The path of the generator, and byte for byte the same from a surface and loops after GapBridging. */
Path
pathBetween(const Cloud::ConstPtr& cloud, const Loops& loops, SpiralReport& report)
{
  auto spiral = generator();
  spiral.setInputCloud(cloud);
  spiral.setBoundaryLoops(loops);
  Path path, by_hand;
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  report = spiral.getReport();
  GapBridging<pcl::PointXYZ> bridging;
  bridging.setInputCloud(cloud);
  bridging.setBoundaryLoops(loops);
  BridgedSurface bridged;
  bridging.compute(bridged);
  EXPECT_TRUE(bridging.getStatus().ok()) << bridging.getStatus().message();
  spiral.setInputSurface(bridged.surface);
  spiral.setBoundaryLoops(bridged.loops);
  spiral.compute(by_hand);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  EXPECT_EQ(by_hand.size(), path.size());
  for (std::size_t i = 0; i < std::min(path.size(), by_hand.size()); ++i)
    if (path[i].getVector3fMap() != by_hand[i].getVector3fMap() || path[i].over_gap != by_hand[i].over_gap) {
      ADD_FAILURE() << "by hand another path from point " << i;
      break;
    }
  return path;
}

TEST(GivenLoops, AnOwnOutlineHoldsWithAndWithoutGaps)
{
  for (const double gap : {0.0, 6.0})
    for (const double gap_x : {10.0, 35.0, 50.0}) { // inside the outline, across it, outside
      SCOPED_TRACE(testing::Message() << "gap " << gap << " at " << gap_x);
      const auto cloud = dome(gap, gap_x);
      Loops loops = test::loopsOf(cloud);
      ASSERT_EQ(loops.size(), gap > 0.0 ? 2u : 1u);
      loops[0] = test::circleOnSphere(sphere, 35.0, LoopType::Outer);
      SpiralReport report;
      const Path path = pathBetween(cloud, loops, report);
      EXPECT_NEAR(reachOf(path).largest, 35.0, 0.05);
      ASSERT_FALSE(report.loops.empty());
      EXPECT_EQ(report.loops[0].curve, loops[0].curve);
      EXPECT_EQ(report.gap_points > 0, gap > 0.0 && gap_x < 50.0);
      if (gap == 0.0)
        break;
    }
}

TEST(GivenLoops, OwnLoopsLeadOverAGapBesideAnotherPart)
{
  const Cloud::Ptr cloud = dome(6.0, 10.0);
  Loops loops = test::loopsOf(cloud);
  loops[0] = test::circleOnSphere(sphere, 35.0, LoopType::Outer);
  *cloud += *dome(0.0, 0.0, 300.0);
  GapBridging<pcl::PointXYZ> bridging;
  bridging.setInputCloud(cloud);
  bridging.setBoundaryLoops(loops);
  BridgedSurface bridged;
  bridging.compute(bridged);
  ASSERT_TRUE(bridging.getStatus().ok()) << bridging.getStatus().message();
  EXPECT_EQ(bridged.gaps.size(), 1U);
  EXPECT_EQ(bridged.loops.front().curve, loops[0].curve);
}

TEST(GivenLoops, AnOwnInnerOutlineHoldsAndTheRimIsFoundAgain)
{
  Cloud::Ptr cloud = dome(4.0, 40.0);
  cloud->erase(std::remove_if(cloud->begin(), cloud->end(), [](const auto& p) { return std::hypot(p.x, p.y) < 15.0; }), cloud->end());
  Loops loops = test::loopsOf(cloud);
  ASSERT_EQ(loops.size(), 3u);
  ASSERT_EQ(loops[1].type, LoopType::Inner);
  loops[1].curve = test::circleOnSphere(sphere, 17.0, LoopType::Inner).curve;
  loops[1].corners.clear();
  SpiralReport report;
  const Reach reach = reachOf(pathBetween(cloud, loops, report));
  EXPECT_NEAR(reach.least, 17.0, 0.05);
  EXPECT_NEAR(reach.largest, rim, 1.0);
  EXPECT_EQ(report.boundaries, 2u);
  EXPECT_GT(report.gap_points, 0u);
  auto ordinary = generator();
  ordinary.setInputCloud(cloud);
  Path path;
  ordinary.compute(path);
  ASSERT_TRUE(ordinary.getStatus().ok()) << ordinary.getStatus().message();
  EXPECT_LT(reachOf(path).least, 16.5);
  EXPECT_EQ(report.loops[0].curve, ordinary.getReport().loops[0].curve);
}

TEST(GivenLoops, FoundLoopsAreFoundAgainAsWithoutThem)
{
  const auto cloud = dome(6.0, 52.0); // close to the rim
  GapBridging<pcl::PointXYZ> bridging;
  bridging.setInputCloud(cloud);
  BridgedSurface found, given;
  bridging.compute(found);
  ASSERT_TRUE(bridging.getStatus().ok()) << bridging.getStatus().message();
  bridging.setBoundaryLoops(test::loopsOf(cloud));
  bridging.compute(given);
  ASSERT_TRUE(bridging.getStatus().ok()) << bridging.getStatus().message();
  ASSERT_EQ(found.loops.size(), given.loops.size());
  for (std::size_t i = 0; i < found.loops.size(); ++i) {
    EXPECT_EQ(found.loops[i].curve, given.loops[i].curve);
    EXPECT_EQ(found.loops[i].indices, given.loops[i].indices);
  }
}

class RefusedLoops : public ::testing::Test {
protected:
  void expectRefused(const Cloud::ConstPtr& cloud, const Loops& loops, const std::string& word)
  {
    GapBridging<pcl::PointXYZ> bridging;
    bridging.setQuiet(true);
    bridging.setInputCloud(cloud);
    bridging.setBoundaryLoops(loops);
    BridgedSurface bridged;
    bridging.compute(bridged);
    EXPECT_EQ(bridging.getStatus().code(), StatusCode::InvalidInput);
    EXPECT_NE(bridging.getStatus().message().find(word), std::string::npos) << bridging.getStatus().message();
    EXPECT_FALSE(bridged.surface);
    EXPECT_TRUE(bridged.loops.empty());
    EXPECT_TRUE(bridging.getGaps().empty());
    auto spiral = generator();
    spiral.setInputCloud(cloud);
    spiral.setBoundaryLoops(loops);
    Path path;
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().message(), bridging.getStatus().message());
    EXPECT_TRUE(path.empty());
  }
};

TEST_F(RefusedLoops, OfAnotherScanWithAGapWhereThisOneHasNone)
{
  expectRefused(dome(0.0, 0.0), test::loopsOf(dome(6.0, 25.0)), "points of the surface lie inside it");
}

TEST_F(RefusedLoops, FarAway)
{
  expectRefused(dome(0.0, 0.0), test::loopsOf(dome(6.0, 25.0, 300.0)), "mm from the cloud");
  expectRefused(dome(0.0, 0.0), test::loopsOf(dome(0.0, 0.0, 300.0)), "mm from the cloud");
}

TEST_F(RefusedLoops, AGapWithoutPoints)
{
  const auto cloud = dome(0.0, 0.0);
  Loops loops = test::loopsOf(cloud);
  loops.emplace_back();
  loops.back().type = LoopType::ScanGap;
  expectRefused(cloud, loops, "loop 1 has 0 curve points");
}

} // namespace

} // namespace given_loops_test
