// SPDX-License-Identifier: BSD-3-Clause
// Shank and holder: their solid, collisions against brute force, and axes tilted to avoid collisions.
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/holder_collision.h>

#include "support/located.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tool_holder_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

const std::vector<ToolSegment> shank_and_chuck{
    ToolSegment::cylinder(5.0, 20.0, "shank"), {15.0, 25.0, 10.0, "nut"}, ToolSegment::cylinder(25.0, 30.0, "chuck")};

/** The segment that contains a place, by the drawing: radii between their ends. */
int
segmentOf(const std::vector<ToolSegment>& segments, double base, double l, double height)
{
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ToolSegment& s = segments[i];
    const double f = (height - base) / s.length;
    if (f > 0.0 && f <= 1.0 && l < (1.0 - f) * s.lower_radius + f * s.upper_radius)
      return static_cast<int>(i);
    base += s.length;
  }
  return -1;
}

} // namespace

TEST(ToolHolder, IsTheSolidOfItsDrawing)
{
  const HolderProfile holder(shank_and_chuck, 12.0, 5.0, 0.0);
  EXPECT_EQ(holder.radius(), 25.0);
  EXPECT_EQ(holder.bottom(), 12.0);
  EXPECT_EQ(holder.top(), 72.0);
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const double l = random.uniform(0.0, 30.0), height = random.uniform(0.0, 80.0);
    double depth = 0.0;
    ASSERT_EQ(holder.inside(l, height, depth), segmentOf(shank_and_chuck, 12.0, l, height)) << l << ' ' << height;
  }
}

TEST(ToolHolder, DepthIsTheShortestWayOut)
{
  const HolderProfile holder(shank_and_chuck, 12.0, 5.0, 0.0);
  double depth = 0.0;
  EXPECT_EQ(holder.inside(4.0, 20.0, depth), 0);
  EXPECT_NEAR(depth, 1.0, 1e-12); // sideways out of the shank
  EXPECT_EQ(holder.inside(10.0, 32.5, depth), 1);
  EXPECT_NEAR(depth, 0.5, 1e-12); // down through the nut's face
  EXPECT_EQ(holder.inside(19.0, 37.0, depth), 1);
  EXPECT_NEAR(depth, std::sqrt(0.5), 1e-12); // across its flank of 45 degrees
  EXPECT_EQ(holder.inside(4.0, 33.0, depth), 1);
  EXPECT_NEAR(depth, 12.0 * std::sqrt(0.5), 1e-12); // above the shank there is no face as a way out
}

TEST(ToolHolder, AClearanceGrowsItSidewaysAndDownwards)
{
  const HolderProfile holder(shank_and_chuck, 12.0, 5.0, 2.0);
  double depth = 0.0;
  EXPECT_EQ(holder.inside(6.5, 20.0, depth), 0);
  EXPECT_NEAR(depth, 0.5, 1e-12);
  EXPECT_EQ(holder.inside(10.0, 30.5, depth), 1);
  EXPECT_NEAR(depth, 0.5, 1e-12);
  EXPECT_EQ(holder.inside(10.0, 29.9, depth), -1);
  EXPECT_EQ(holder.inside(26.5, 60.0, depth), 2);
  EXPECT_EQ(holder.inside(4.0, 11.9, depth), -1); // the lower end of the shank is the top of the cutter
}

TEST(ToolHolder, CollisionsEqualBruteForce)
{
  Random random(2);
  int found = 0;
  for (int k = 0; k < 500; ++k) {
    std::vector<Eigen::Vector3f> points(500);
    for (Eigen::Vector3f& p : points)
      p = Vector3d(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60)).cast<float>();
    const double clearance = random.below(2) * random.uniform(0.0, 3.0), tip = random.uniform(-20.0, 20.0);
    const HolderProfile holder(shank_and_chuck, 12.0, 5.0, clearance);
    const Vector3d axis = Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const Vector3d through(random.uniform(-80, 80), random.uniform(-80, 80), 0.0);
    const HolderCollision worst = findCollision(PointBlocks(points), holder, AxisFrame(through, axis), tip, 0.5);
    double deepest = 0.5;
    int segment = -1;
    for (const Eigen::Vector3f& point : points) {
      const Vector3d d = point.cast<double>() - through;
      double depth = 0.0;
      const int inside = holder.inside(d.cross(axis).norm(), d.dot(axis) - tip, depth);
      if (inside >= 0 && depth > deepest) {
        deepest = depth;
        segment = inside;
      }
    }
    ASSERT_EQ(worst.segment, segment);
    if (!worst.found())
      continue;
    ++found;
    ASSERT_NEAR(worst.depth, deepest, 1e-9);
    ASSERT_EQ(points[worst.cloud_index].cast<double>(), worst.place);
  }
  EXPECT_GT(found, 100);
  EXPECT_LT(found, 500);
}

TEST(ToolHolder, SegmentsThatCannotBeAreNamed)
{
  EXPECT_EQ(faultOf(shank_and_chuck), "");
  EXPECT_EQ(faultOf(std::vector<ToolSegment>{{5, 5, 0, "shank"}}), "segment 1 of the holder (shank) is 0 mm long; set its length above 0");
  EXPECT_NE(faultOf(std::vector<ToolSegment>{{5, 5, 1, ""}, {-1, 5, 2, ""}}).text().find("segment 2 of the holder has the lower"),
            std::string::npos);
  EXPECT_NE(faultOf(std::vector<ToolSegment>{{5, std::nan(""), 1, ""}}).text().find("upper radius nan"), std::string::npos);
  EXPECT_THROW(HolderProfile({{5, 5, 0, ""}}, 0.0, 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(HolderProfile(shank_and_chuck, 0.0, 1.0, -1.0), std::invalid_argument);
}

namespace {

/** A floor with a wall of height 40 at x = 10, both scanned. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
floorAndWall()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  Random random(3);
  for (int i = 0; i < 20000; ++i)
    cloud->emplace_back(random.uniform(-30, 10), random.uniform(-30, 30), 0.0);
  for (int i = 0; i < 20000; ++i)
    cloud->emplace_back(10.0, random.uniform(-30, 30), random.uniform(0, 40));
  return cloud;
}

} // namespace

TEST(ToolHolder, CollisionsAreFoundReportedAndTiltedAway)
{
  const Vector3d up = Vector3d::UnitZ();
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(floorAndWall());
  location.setCutter(CutterShape::ball(3.0, 10.0));
  location.setHolder({ToolSegment::cylinder(3.0, 10.0, "shank"), ToolSegment::cylinder(12.0, 30.0, "chuck")});
  location.setDrivePoints({{{0, 0, 0}, up, up}, {{-15, 0, 0}, up, up}});
  ToolLocations found;
  location.compute(found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].state, LocationState::Reached);
  ASSERT_TRUE(found[0].collision.found());
  EXPECT_EQ(found[0].collision.segment, 1);
  EXPECT_NEAR(found[0].collision.depth, 2.0, 0.05); // the chuck reaches 12, the wall is at 10
  EXPECT_NEAR(found[0].collision.place.x(), 10.0, 1e-6);
  EXPECT_FALSE(found[1].collision.found());
  EXPECT_EQ(location.getReport().collisions, 1u);
  EXPECT_EQ(location.getReport().most_collided, 0u);
  bool said = false;
  for (const pcl_spiral::Diagnostic& warning : location.getReport().warnings)
    said = said || warning.text().find("chuck of location 0 at (10, ") != std::string::npos;
  EXPECT_TRUE(said);

  location.setLocationSurface(location.getLocationSurface());
  location.setMaxRetilt(30.0);
  location.compute(found);
  EXPECT_EQ(found[0].state, LocationState::Reached);
  EXPECT_FALSE(found[0].collision.found());
  EXPECT_GT(found[0].retilt, 0.0);
  EXPECT_LE(found[0].retilt, 30.0);
  EXPECT_LT(found[0].axis.x(), 0.0); // away from the wall
  EXPECT_NEAR(std::acos(found[0].axis.z()) * 180.0 / M_PI, found[0].retilt, 1e-6);
  EXPECT_LT((found[0].tip + 3.0 * found[0].axis - Vector3d(0, 0, 3)).norm(),
            1e-3); // the ball does not move
  EXPECT_EQ(found[1].retilt, 0.0);
  EXPECT_EQ(location.getReport().retilted, 1u);
}

TEST(ToolHolder, WhereNoTiltHelpsTheCutterIsLifted)
{
  // Along the foot of the wall a ball of 3 tilted towards it is lifted out; upright and 2 from it, no tilt
  // helps.
  const Vector3d up = Vector3d::UnitZ(), leaning = Vector3d(0.5, 0.0, 1.0).normalized();
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(floorAndWall());
  location.setCutter(CutterShape::ball(3.0, 30.0));
  location.setDrivePoints({{{6, 0, 0}, leaning, up}, {{8, 0, 0}, up, up}});
  location.setMaxRetilt(45.0);
  ToolLocations found;
  location.compute(found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].state, LocationState::Reached);
  EXPECT_GT(found[0].retilt, 20.0);
  EXPECT_LT(found[0].axis.x(), 0.1);
  EXPECT_EQ(found[1].state, LocationState::Lifted);
  EXPECT_EQ(found[1].retilt, 0.0);
  EXPECT_GT(found[1].lift, 30.0); // over the top of the wall: its side is steeper than any axis of the cone
}

TEST(ToolHolder, AFlankThatIsLeantOverIsTiltedUntilItTouches)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0)}));
  const Vector3d up = Vector3d::UnitZ(), steep(std::sin(1.2), 0.0, std::cos(1.2)); // 68.8 degrees off the normal
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(toCloud(sampleUniform(*plane, 12000, 4).points));
  location.setCutter(CutterShape::taperedBullNose(6.0, 1.0, 8.0, 30.0));
  location.setDrivePoints({{Vector3d::Zero(), steep, up}});
  ToolLocations found;
  location.compute(found);
  EXPECT_EQ(found[0].state, LocationState::Unreachable);
  location.setMaxRetilt(20.0);
  location.compute(found);
  EXPECT_EQ(found[0].state, LocationState::Reached);
  EXPECT_NEAR(found[0].retilt, 10.0, 1e-9); // 8.8 are needed, in steps of a sixth of 20
  location.setDrivePoints({{Vector3d::Zero(), steep, Vector3d::Zero()}});
  location.compute(found);
  EXPECT_TRUE(found.empty());
  EXPECT_NE(location.getStatus().message().find("no drive point asks for one"), std::string::npos) << location.getStatus().message();
}

} // namespace tool_holder_test
