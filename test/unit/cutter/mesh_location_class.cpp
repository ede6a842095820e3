// SPDX-License-Identifier: BSD-3-Clause
// The class CutterLocation on meshes: changes that must not change its output, and refusals.
#include <pcl_spiral/cutter/cutter_location.h>

#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace mesh_location_class_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

TEST(MeshLocation, AxesAreTiltedAndMovesBisectedAsOnClouds)
{
  const PlainMesh mesh = pocket();
  const Located tilted =
      onMesh(mesh.polygons(), CutterShape::ball(2.0, 30.0), {{{0, 0, 0}, {0.9, 0, 1}, up}}, [](Location& l) { l.setMaxRetilt(40.0); });
  EXPECT_EQ(tilted.locations[0].state, LocationState::Reached);
  EXPECT_GT(tilted.locations[0].retilt, 1.0);
  const Waves waves{2.0, 0.3};
  DrivePoints line;
  for (double x = -8.0; x <= 8.0; x += 4.0)
    line.push_back({waves.at(x, 0.0), up, none});
  const Located bisected = onMesh(waves.mesh(0.5).polygons(), CutterShape::ball(3.0), line, [](Location& l) { l.setPathTolerance(0.01); });
  EXPECT_GT(bisected.locations.size(), 4 * line.size());
}

TEST(MeshLocation, ThreadsAndComputingAgainChangeNothingAndMotionMovesAll)
{
  const Waves waves{2.0, 0.3};
  const PlainMesh plain = waves.mesh(0.5);
  DrivePoints drive = contactsOn(waves, -10.0, 10.0, 4);
  for (std::size_t i = 0; i < drive.size(); i += 2)
    drive[i].normal.setZero();
  Location location;
  location.setInputMesh(plain.polygons());
  location.setCutter(all_kinds[5]);
  location.setDrivePoints(drive);
  ToolLocations one, again;
  location.setNumberOfThreads(1);
  location.compute(one);
  ASSERT_EQ(one.size(), drive.size());
  location.setNumberOfThreads(2);
  location.compute(again);
  Location other;
  other.setInputMesh(location.getInputMesh());
  other.setCutter(all_kinds[5]);
  other.setDrivePoints(drive);
  ToolLocations third;
  other.compute(third);
  const Eigen::Isometry3d motion = randomMotion(5, 100.0);
  PlainMesh moved = plain;
  for (Vector3d& p : moved.corners)
    p = motion * p.cast<float>().cast<double>();
  DrivePoints led;
  for (const DrivePoint& d : drive)
    led.push_back({motion * d.position, motion.linear() * d.axis, motion.linear() * d.normal});
  const Located away = onMesh(moved.polygons(), all_kinds[5], led);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].tip, again[i].tip);
    ASSERT_EQ(one[i].tip, third[i].tip);
    ASSERT_LT((motion * one[i].tip - away.locations[i].tip).norm(), 1e-3) << i;
    EXPECT_EQ(one[i].state, away.locations[i].state) << i;
  }
}

TEST(MeshLocation, WhatIsSetLastCounts)
{
  PlainMesh high, low;
  high.addQuad({-9, -9, 5}, {9, -9, 5}, {9, 9, 5}, {-9, 9, 5});
  low.addQuad({-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1});
  const auto cloud = toCloud(sampleUniform(*flat(Region({rectangle(20.0, 20.0)})), 2000, 6).points);
  Location location;
  location.setCutter(CutterShape::ball(2.0));
  location.setDrivePoints({{{0, 0, 9}, up, none}});
  const auto height = [&] {
    ToolLocations locations;
    location.compute(locations);
    EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
    return locations.empty() ? -99.0 : locations[0].tip.z();
  };
  location.setInputCloud(cloud);
  EXPECT_NEAR(height(), 0.0, 1e-3);
  location.setInputMesh(high.polygons());
  EXPECT_NEAR(height(), 5.0, 1e-9);
  location.setInputMesh(low.surface());
  EXPECT_NEAR(height(), 1.0, 1e-9);
  EXPECT_EQ(location.getInputMesh()->faceCount(), 2u);
  location.setInputCloud(cloud);
  EXPECT_NEAR(height(), 0.0, 1e-3);
  EXPECT_EQ(location.getInputMesh(), nullptr);
}

TEST(MeshLocation, MeshesAndSettingsThatCannotBeAreNamed)
{
  const auto fails = [&](const char* says, auto change) {
    Location location;
    location.setInputMesh(pocket().polygons());
    location.setCutter(CutterShape::ball(2.0));
    location.setDrivePoints({{none, up, up}});
    location.setQuiet(true);
    change(location);
    ToolLocations locations(3);
    location.compute(locations);
    EXPECT_FALSE(location.getStatus().ok()) << says;
    EXPECT_NE(location.getStatus().message().find(says), std::string::npos) << location.getStatus().message();
    EXPECT_TRUE(locations.empty());
  };
  fails("has no gaps between points: set the evaluation", [](Location& l) { l.setEvaluation(Evaluation::PointsAndBound); });
  fails("input mesh is missing", [](Location& l) { l.setInputMesh(pcl::PolygonMesh::ConstPtr()); });
  fails("input mesh is missing", [](Location& l) { l.setInputMesh(SurfaceMesh::ConstPtr()); });
  fails("no ", [](Location& l) { l.setInputMesh(pcl::PolygonMesh::ConstPtr(new pcl::PolygonMesh)); });
  fails("not finite", [](Location& l) {
    PlainMesh mesh = pocket();
    mesh.corners[2].y() = std::numeric_limits<double>::quiet_NaN();
    l.setInputMesh(mesh.polygons());
  });
  fails("setThinning was called beside setInputMesh", [](Location& l) { l.setThinning(0.5); });
  fails("setFlipNormals was called beside setInputMesh", [](Location& l) { l.setFlipNormals(true); });
  fails("setInputNormals was called beside",
        [](Location& l) { l.setInputNormals(pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>(5, 1))); });
  fails("radius is 0 mm", [](Location& l) { l.setCutter(CutterShape()); });
  fails("threads is 4294967295", [](Location& l) { l.setNumberOfThreads(-1); });
  fails("cancelled", [](Location& l) { l.setProgressCallback([](double, const std::string& s) { return s != "locations"; }); });
}

} // namespace mesh_location_class_test
