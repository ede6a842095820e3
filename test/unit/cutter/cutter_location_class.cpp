// SPDX-License-Identifier: BSD-3-Clause
// The class CutterLocation: changes that must not change its output, and refusals.
#include <pcl_spiral/cutter/cutter_location.h>

#include "support/located.h"

#include <gtest/gtest.h>
#include <pcl/common/io.h>

#include <limits>

namespace cutter_location_class_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

TEST(CutterLocation, MovesWithThePart)
{
  const SurfacePtr part = quadric(90.0, -60.0, Region({circle({0, 0}, 30.0)}));
  const Sampled sampled = sampleUniform(*part, 10000, 14);
  DrivePoints drive = drivePoints(*part, 200, 35.0, 3.0, true, 15);
  for (std::size_t i = 0; i < drive.size(); i += 2)
    drive[i].normal.setZero();
  const CutterShape shape = all_kinds[5];
  const Located still = located(toCloud(sampled.points), shape, drive);
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Eigen::Isometry3d motion = randomMotion(seed, 100.0);
    std::vector<Vector3d> points;
    for (const Vector3d& p : sampled.points)
      points.push_back(motion * p);
    DrivePoints moved;
    for (const DrivePoint& d : drive)
      moved.push_back({motion * d.position, motion.linear() * d.axis, motion.linear() * d.normal});
    const Located run = located(toCloud(points), shape, moved);
    std::size_t same = 0;
    for (std::size_t i = 0; i < drive.size(); ++i) {
      ASSERT_LT((run.locations[i].tip - motion * still.locations[i].tip).norm(), 2e-3) << i;
      same += (run.locations[i].tip - motion * still.locations[i].tip).norm() < 3e-5;
      EXPECT_EQ(run.locations[i].state, still.locations[i].state);
    }
    EXPECT_GT(same, 98 * drive.size() / 100); // the others are near the rim, or where a fit is just not accepted
  }
}

TEST(CutterLocation, ThreadsAndOrderOfTheCloudChangeNothing)
{
  const SurfacePtr part = quadric(90.0, -60.0, Region({circle({0, 0}, 30.0)}));
  const Sampled sampled = sampleUniform(*part, 8000, 16);
  const DrivePoints drive = drivePoints(*part, 10000, 35.0, 1.0, true, 17);
  const auto cloud = toCloud(sampled.points);
  const Located one = located(cloud, all_kinds[5], drive, Evaluation::FittedSurface, 1);
  std::vector<Vector3d> points;
  const std::vector<std::size_t> order = shuffled(sampled.points.size(), 18);
  for (const std::size_t i : order)
    points.push_back(sampled.points[i]);
  const Located three = located(cloud, all_kinds[5], drive, Evaluation::FittedSurface, 3);
  const Located other = located(toCloud(points), all_kinds[5], drive);
  for (std::size_t i = 0; i < drive.size(); ++i)
    for (const Located* run : {&three, &other}) {
      ASSERT_EQ(run->locations[i].tip, one.locations[i].tip) << i;
      ASSERT_EQ(run->locations[i].gap_bound, one.locations[i].gap_bound);
      ASSERT_EQ(run == &other ? order[run->locations[i].cloud_index] : run->locations[i].cloud_index, one.locations[i].cloud_index);
    }
}

TEST(CutterLocation, AnEchoAboveTheSurfaceLiftsAndIsReported)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0)}));
  std::vector<Vector3d> points = sampleUniform(*plane, 8000, 19).points;
  points.emplace_back(1.0, 0.0, 3.0);
  const Vector3d up = Vector3d::UnitZ();
  const Located run = located(toCloud(points), CutterShape::ball(4.0), {{{0, 0, 0}, up, up}, {{15, 0, 0}, up, up}});
  EXPECT_EQ(run.locations[0].state, LocationState::Lifted);
  EXPECT_EQ(run.locations[0].cloud_index, points.size() - 1);
  EXPECT_GE(run.locations[0].lift, 3.0 - 4.0 + std::sqrt(15.0) - 1e-9);
  EXPECT_NE(run.locations[0].basis, LocationBasis::FittedSurface);
  EXPECT_EQ(run.locations[1].state, LocationState::Reached);
  EXPECT_EQ(run.figures.most_lifted, 0u);
  EXPECT_EQ(run.figures.outlier_points, 1u);
}

TEST(CutterLocation, PathsCloudsAndSettingsThatCannotBeAreNamed)
{
  const SurfacePtr plane = flat(Region({rectangle(20.0, 20.0)}));
  const auto cloud = toCloud(sampleUniform(*plane, 2000, 20).points);
  const Vector3d up = Vector3d::UnitZ();
  const auto fails = [&](const char* says, auto change) {
    CutterLocation<pcl::PointXYZ> location;
    location.setInputCloud(cloud);
    location.setCutter(CutterShape::ball(2.0));
    location.setDrivePoints({{Vector3d::Zero(), up, up}});
    change(location);
    ToolLocations locations(3);
    location.compute(locations);
    EXPECT_FALSE(location.getStatus().ok()) << says;
    EXPECT_NE(location.getStatus().message().find(says), std::string::npos) << location.getStatus().message();
    EXPECT_TRUE(locations.empty());
  };
  using Location = CutterLocation<pcl::PointXYZ>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fails("missing or empty", [](Location& l) { l.setInputCloud(Cloud::Ptr(new Cloud)); });
  fails("radius is 0 mm; set it above 0", [](Location& l) { l.setCutter(CutterShape()); });
  fails("corner reaches across", [](Location& l) { l.setCutter(CutterShape::bullNose(2.0, 3.0)); });
  fails("no drive points", [](Location& l) { l.setDrivePoints({}); });
  fails("drive point 0 at (1, 2, 3) has no tool axis", [&](Location& l) { l.setDrivePoints({{{1, 2, 3}, {0, 0, 0}, up}}); });
  fails("drive point 1, its axis or its normal is not finite", [&](Location& l) {
    l.setDrivePoints({{{1, 2, 3}, up, up}, {{1, nan, 3}, up, up}});
  });
  fails("tolerance is -1 mm", [](Location& l) { l.setContactTolerance(-1.0); });
  fails("threads is 4294967295", [](Location& l) { l.setNumberOfThreads(-1); });
  fails("cancelled", [](Location& l) { l.setProgressCallback([](double, const std::string& s) { return s != "locations"; }); });
  Cloud::Ptr few(new Cloud(10, 1, pcl::PointXYZ(1, 2, 3)));
  for (std::size_t i = 0; i < few->size(); ++i)
    (*few)[i].x = static_cast<float>(i);
  fails("Evaluation::Points", [&](Location& l) { l.setInputCloud(few); });
  Cloud::Ptr none(new Cloud(10, 1, pcl::PointXYZ(static_cast<float>(nan), 0, 0)));
  fails("finite", [&](Location& l) { l.setInputCloud(none); });
  const auto by_points = [&](const char* says, auto change) {
    fails(says, [&](Location& l) {
      l.setEvaluation(Evaluation::Points);
      change(l);
    });
  };
  by_points("the view point is nan,0,0: its coordinates must be finite", [&](Location& l) { l.setViewPoint(Vector3d(nan, 0.0, 0.0)); });
  by_points("there are 5 normals for 2000 points",
            [](Location& l) { l.setInputNormals(pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>(5, 1))); });
  const Located points = located(few, CutterShape::ball(2.0), {{{1, 2, 0}, up, Vector3d::Zero()}}, Evaluation::Points);
  EXPECT_NEAR(points.locations[0].tip.z(), 3.0, 1e-6);
  EXPECT_EQ(points.figures.warnings.size(), 2u);
}

TEST(CutterLocation, TakesAToolpathAndASurfaceMadeBefore)
{
  const SurfacePtr part = quadric(-80.0, -150.0, Region({circle({0, 0}, 30.0)}));
  const Sampled sampled = sampleUniform(*part, 10000, 21);
  pcl::PointCloud<ToolpathPoint> path;
  for (int i = -10; i <= 10; ++i) {
    ToolpathPoint p;
    const Vector3d at = part->lift({i, 0.5 * i});
    p.getVector3fMap() = at.cast<float>();
    p.getNormalVector3fMap() = part->normal(at).cast<float>();
    p.getAxisVector3fMap() = Eigen::Vector3f(0.2f, 0.1f, 1.0f);
    path.push_back(p);
  }
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  pcl::copyPointCloud(*toCloud(sampled.points), *cloud);
  CutterLocation<pcl::PointNormal> location;
  location.setInputCloud(cloud);
  location.setCutter(CutterShape::bullNose(3.0, 1.0));
  location.setDrivePath(path);
  ToolLocations first, second;
  location.compute(first);
  ASSERT_EQ(first.size(), path.size());
  EXPECT_EQ(location.getReport().count(LocationState::Reached), path.size());
  location.setLocationSurface(location.getLocationSurface());
  location.compute(second);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_EQ(first[i].tip, second[i].tip);
}

} // namespace cutter_location_class_test
