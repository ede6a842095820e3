// SPDX-License-Identifier: BSD-3-Clause
// Axes that lean away from a wall where the holder would hit it, smoothly along the pass: the angle from one location to the next, and the
// tool against every point of the scan by brute force.
#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace smooth_retilt_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double R = 3.0, shank_top = 23.0, chuck_top = 53.0, chuck = 12.0; // heights above the tip

/** A floor, and a wall 40 mm high at x = 10 that is 12 mm wide. */
Cloud::Ptr
floorAndPost()
{
  const Cloud::Ptr cloud(new Cloud);
  Random random(3);
  for (int i = 0; i < 14000; ++i)
    cloud->emplace_back(random.uniform(-30, 10), random.uniform(-60, 60), 0.0);
  for (int i = 0; i < 4000; ++i)
    cloud->emplace_back(10.0, random.uniform(-6, 6), random.uniform(0, 40));
  return cloud;
}

PlainMesh
meshOfThem()
{
  PlainMesh m;
  m.addQuad({-30, -60, 0}, {10, -60, 0}, {10, 60, 0}, {-30, 60, 0});
  m.addQuad({10, -6, 0}, {10, 6, 0}, {10, 6, 40}, {10, -6, 40});
  return m;
}

/** A pass along the wall. */
DrivePoints
alongTheWall(bool contacts)
{
  DrivePoints drive;
  for (double y = -45.0; y <= 45.0; y += 1.0)
    drive.push_back({{0.0, y, 0.0}, up, contacts ? up : none});
  return drive;
}

template <typename Change>
ToolLocations
leant(const Change& change)
{
  Location location;
  location.setCutter(CutterShape::ball(R, 10.0));
  location.setHolder({ToolSegment::cylinder(R, 10.0, "shank"), ToolSegment::cylinder(chuck, 30.0, "chuck")});
  location.setMaxRetilt(40.0);
  location.setRetiltStep(2.0);
  change(location);
  ToolLocations found;
  location.compute(found);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  return found;
}

double
largestStep(const ToolLocations& pass)
{
  double largest = 0.0;
  for (std::size_t i = 1; i < pass.size(); ++i)
    largest = std::max(largest, std::atan2(pass[i].axis.cross(pass[i - 1].axis).norm(), pass[i].axis.dot(pass[i - 1].axis)));
  return largest * 180.0 / M_PI;
}

/** How deep the deepest point is in ball, shank and chuck. */
double
deepestInTool(const Cloud& cloud, const ToolLocation& location)
{
  double deepest = -1e300;
  for (const pcl::PointXYZ& p : cloud) {
    const Vector3d d = p.getVector3fMap().cast<double>() - location.tip;
    const double h = d.dot(location.axis), l = d.cross(location.axis).norm();
    if (h > R && h < shank_top)
      deepest = std::max(deepest, R - l);
    else if (h >= shank_top && h < chuck_top)
      deepest = std::max(deepest, std::min(chuck - l, l > R ? h - shank_top : chuck));
    else if (h <= R)
      deepest = std::max(deepest, R - (d - R * location.axis).norm());
  }
  return deepest;
}

void
expectFreeAndSmooth(const ToolLocations& pass, const Cloud& cloud)
{
  ASSERT_GE(pass.size(), 91u);
  EXPECT_LE(largestStep(pass), 2.0 + 1e-6);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < pass.size(); ++i) {
    EXPECT_LT(deepestInTool(cloud, pass[i]), 0.03) << i << ' ' << pass[i].tip.transpose();
    EXPECT_FALSE(pass[i].collision.found()) << i;
    EXPECT_LT((pass[i].tip + R * pass[i].axis - Vector3d(0.0, pass[i].tip.y() + R * pass[i].axis.y(), R)).norm(), 0.03)
        << "the ball stays on its row " << i;
    turned += pass[i].retilt > 0.0;
  }
  EXPECT_GT(turned, 15u);
  EXPECT_EQ(pass.front().retilt, 0.0);
  EXPECT_EQ(pass.back().retilt, 0.0);
  EXPECT_EQ(pass.front().axis, up);
}

} // namespace

TEST(SmoothRetilt, AxesLeanAwayFromAWallWithoutJumps)
{
  const Cloud::Ptr cloud = floorAndPost();
  const auto asked = [&](Location& l) {
    l.setInputCloud(cloud);
    l.setDrivePoints(alongTheWall(true));
  };
  const ToolLocations straight = leant([&](Location& l) {
    asked(l);
    l.setMaxRetilt(0.0);
  });
  EXPECT_GT(std::count_if(straight.begin(), straight.end(), [](const ToolLocation& l) { return l.collision.found(); }), 10);
  const ToolLocations each = leant([&](Location& l) {
    asked(l);
    l.setRetiltStep(0.0);
  });
  EXPECT_GT(largestStep(each), 5.0) << "each location by itself jumps";
  expectFreeAndSmooth(leant(asked), *cloud);
}

TEST(SmoothRetilt, WithLocationsInBetweenAndWithoutContactsAskedFor)
{
  const Cloud::Ptr cloud = floorAndPost();
  for (const bool contacts : {true, false}) {
    const ToolLocations pass = leant([&](Location& l) {
      l.setInputCloud(cloud);
      l.setDrivePoints(alongTheWall(contacts));
      l.setPathTolerance(0.01);
    });
    expectFreeAndSmooth(pass, *cloud);
  }
}

TEST(SmoothRetilt, OnAMeshToo)
{
  const Cloud::Ptr cloud = floorAndPost();
  const ToolLocations pass = leant([](Location& l) {
    l.setInputMesh(meshOfThem().polygons());
    l.setDrivePoints(alongTheWall(true));
    l.setPathTolerance(0.01);
  });
  expectFreeAndSmooth(pass, *cloud);
}

TEST(SmoothRetilt, WhereNoTurnHelpsTheCollisionIsStillReported)
{
  const Cloud::Ptr cloud = floorAndPost();
  const ToolLocations pass = leant([&](Location& l) {
    l.setInputCloud(cloud);
    l.setDrivePoints(alongTheWall(true));
    l.setMaxRetilt(2.0);
    l.setRetiltStep(1.0);
  });
  std::size_t collisions = 0;
  for (const ToolLocation& location : pass) {
    collisions += location.collision.found();
    if (!location.collision.found())
      EXPECT_LT(deepestInTool(*cloud, location), 0.03);
  }
  EXPECT_GT(collisions, 5u);
  EXPECT_LE(largestStep(pass), 1.0 + 1e-6);
}

TEST(SmoothRetilt, ThreadsChangeNothing)
{
  const Cloud::Ptr cloud = floorAndPost();
  std::vector<ToolLocations> runs;
  for (const unsigned int threads : {1u, 2u})
    runs.push_back(leant([&](Location& l) {
      l.setInputCloud(cloud);
      l.setDrivePoints(alongTheWall(true));
      l.setNumberOfThreads(threads);
    }));
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    EXPECT_EQ(runs[0][i].tip, runs[1][i].tip);
    EXPECT_EQ(runs[0][i].axis, runs[1][i].axis);
  }
}

} // namespace smooth_retilt_test
