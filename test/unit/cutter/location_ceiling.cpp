// SPDX-License-Identifier: BSD-3-Clause
// Where the cutter comes from: what is above the ceiling does not hold it up, but what of it is in the tool is found. Against brute force
// over the points and dense samples of triangles, and in closed form in a bore and under a roof.
#include "cutter/mesh_drop.h"
#include <pcl_spiral/cutter/impl/cutter_drop.h>

#include "support/cutters.h"
#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace location_ceiling_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double bore = 30.0; // radius, about y

Vector3d
onBore(double angle, double y)
{
  return {bore * std::sin(angle), y, -bore * std::cos(angle)};
}

Vector3d
inwards(double angle)
{
  return {-std::sin(angle), 0.0, std::cos(angle)};
}

Cloud::Ptr
boreCloud()
{
  const Cloud::Ptr cloud(new Cloud);
  Random random(4);
  for (int i = 0; i < 16000; ++i) {
    const Vector3d p = onBore(random.uniform(-M_PI, M_PI), random.uniform(-20, 20));
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  return cloud;
}

PlainMesh
boreMesh()
{
  constexpr int around = 120;
  PlainMesh mesh;
  for (int i = 0; i < around; ++i) {
    const double a = 2.0 * M_PI * i / around, b = 2.0 * M_PI * (i + 1) / around;
    for (double y = -20.0; y < 20.0; y += 4.0)
      mesh.addQuad(onBore(a, y), onBore(b, y), onBore(b, y + 4.0), onBore(a, y + 4.0));
  }
  return mesh;
}

/** Contacts on the wall, axes towards the middle, up to 10 degrees off the normal. */
DrivePoints
boreContacts(std::size_t count)
{
  Random random(8);
  DrivePoints drive;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = random.uniform(-M_PI, M_PI), y = random.uniform(-8, 8);
    drive.push_back({onBore(angle, y), leaning(inwards(angle), 10.0, random), inwards(angle)});
  }
  return drive;
}

const std::vector<ToolSegment> short_shank{ToolSegment::cylinder(4.0, 20.0, "shank")};

/** Two plates, the upper one at the given height. */
Cloud::Ptr
plates(double roof)
{
  const Cloud::Ptr cloud(new Cloud);
  for (double x = -20.0; x <= 20.0; x += 0.5)
    for (double y = -20.0; y <= 20.0; y += 0.5) {
      cloud->emplace_back(x, y, 0.0);
      cloud->emplace_back(x, y, roof);
    }
  return cloud;
}

template <typename Change>
ToolLocation
underRoof(double roof, const Change& change)
{
  Location location;
  location.setInputCloud(plates(roof));
  location.setEvaluation(Evaluation::Points);
  location.setCutter(CutterShape::ball(4.0, 6.0));
  location.setDrivePoints({{{0, 0, 0}, up, up}});
  change(location);
  ToolLocations found;
  location.compute(found);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  return found.empty() ? ToolLocation() : found[0];
}

} // namespace

TEST(LocationCeiling, PointsAboveItDoNotHoldTheCutter)
{
  Random random(1);
  std::size_t changed = 0;
  for (int cloud = 0; cloud < 40; ++cloud) {
    std::vector<Eigen::Vector3f> points(1 + random.below(300));
    for (Eigen::Vector3f& p : points)
      p = Vector3d(random.uniform(-15, 15), random.uniform(-15, 15), random.uniform(-15, 15)).cast<float>();
    const PointBlocks blocks(points);
    for (int k = 0; k < 50; ++k) {
      const CutterProfile cutter(randomCutter(random));
      const AxisFrame frame({random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)}, leaning(up, 180.0, random));
      const double ceiling = random.uniform(-8, 16);
      double highest = -endless, without = -endless;
      for (const Eigen::Vector3f& point : points) {
        const double along = frame.along(point.cast<double>()), l = frame.across(point.cast<double>()).norm();
        if (l > cutter.radius())
          continue;
        without = std::max(without, along - cutter.height(l));
        if (along <= ceiling)
          highest = std::max(highest, along - cutter.height(l));
      }
      const DropContact drop = CutterDrop(blocks, cutter, ceiling).highest(frame);
      ASSERT_EQ(drop.found, std::isfinite(highest));
      if (drop.found)
        ASSERT_NEAR(drop.height, highest, 1e-5) << cloud << ' ' << k;
      changed += highest != without;
    }
  }
  EXPECT_GT(changed, 300u);
}

TEST(LocationCeiling, OfTrianglesOnlyTheLowerPartHoldsTheCutter)
{
  constexpr int n = 250;
  Random random(2);
  std::size_t cut = 0;
  for (int k = 0; k < 400; ++k) {
    PatchCell cell;
    for (int i = 0; i < 3; ++i)
      cell.corners.col(i) = Vector3d(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    cell.bows.setZero();
    const CutterProfile cutter(randomCutter(random));
    const AxisFrame frame({random.uniform(-3, 3), random.uniform(-3, 3), 0.0}, leaning(up, 60.0, random));
    const double ceiling = random.uniform(-6, 8);
    double highest = -endless;
    bool above = false;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vector3d p = cell.corners * Vector3d(i, j, n - i - j) / n;
        const double along = frame.along(p), l = frame.across(p).norm();
        above = above || along > ceiling;
        if (along <= ceiling && l <= cutter.radius())
          highest = std::max(highest, along - cutter.height(l));
      }
    cut += above && std::isfinite(highest);
    const PatchTree patches({cell});
    const MeshContact found = MeshDrop(patches, cutter, endless, ceiling).highest(frame);
    if (std::isfinite(highest)) {
      ASSERT_TRUE(found.found) << k;
      EXPECT_GE(found.height, highest - 1e-9) << k;
    }
    if (!found.found)
      continue;
    const double along = frame.along(found.contact), l = frame.across(found.contact).norm();
    EXPECT_LE(along, ceiling + 1e-9) << k;
    EXPECT_LE(l, cutter.radius() + 1e-6) << k;
    EXPECT_NEAR(along - cutter.height(std::min(l, cutter.radius())), found.height, 1e-4) << k;
    EXPECT_LT((cell.corners * found.weights - found.contact).norm(), 1e-9) << k;
  }
  EXPECT_GT(cut, 100u);
}

TEST(LocationCeiling, InABoreTheCutterStandsAtTheNearWall)
{
  const CutterShape cutter = CutterShape::ball(4.0, 12.0);
  const Cloud::Ptr cloud = boreCloud();
  const DrivePoints drive = boreContacts(100);
  Location location;
  location.setInputCloud(cloud);
  location.setViewPoint(Vector3d::Zero());
  location.setCutter(cutter);
  location.setDrivePoints(drive);
  for (const bool held : {true, false}) { // by a shank 36 mm long together, or a tool taken as 44 mm long
    location.setHolder(held ? short_shank : std::vector<ToolSegment>());
    ToolLocations found;
    location.compute(found);
    ASSERT_EQ(found.size(), drive.size()) << location.getStatus().message();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Vector3d axis = drive[i].axis.normalized();
      EXPECT_LT((found[i].tip - drive[i].position - 4.0 * (drive[i].normal - axis)).norm(), 0.02) << i;
      EXPECT_LT(found[i].lift, 0.02) << i;
      EXPECT_TRUE(found[i].under_scan) << i;
      EXPECT_FALSE(found[i].collision.found()) << i;
      for (const pcl::PointXYZ& p : *cloud) {
        const Vector3d d = p.getVector3fMap().cast<double>() - found[i].tip;
        const double h = d.dot(axis), l = d.cross(axis).norm();
        if (h > 4.0 && h < 36.0)
          ASSERT_GT(l, 4.0 - 0.02) << i;
        else if (h <= 4.0)
          ASSERT_GT((d - 4.0 * axis).norm(), 4.0 - 0.02) << i;
      }
    }
    EXPECT_EQ(location.getReport().under_scan, drive.size());
  }
  location.setCeiling(endless);
  ToolLocations found;
  location.compute(found);
  for (const ToolLocation& l : found)
    EXPECT_GT(l.lift, 20.0) << "onto the opposite wall";
}

TEST(LocationCeiling, InABoreOfTrianglesToo)
{
  const DrivePoints drive = boreContacts(100);
  const Located run = onMesh(boreMesh().polygons(), CutterShape::ball(4.0, 12.0), drive, [](Location& l) { l.setHolder(short_shank); });
  for (std::size_t i = 0; i < drive.size(); ++i) {
    EXPECT_LT((run.locations[i].tip - drive[i].position - 4.0 * (drive[i].normal - drive[i].axis.normalized())).norm(), 0.01) << i;
    EXPECT_TRUE(run.locations[i].under_scan);
    EXPECT_FALSE(run.locations[i].collision.found()) << i;
  }
}

TEST(LocationCeiling, UnderARoofTheCutterStaysOnThePlate)
{
  EXPECT_NEAR(underRoof(25.0, [](Location& l) { l.setCeiling(endless); }).tip.z(), 25.0, 0.05);
  const ToolLocation below = underRoof(25.0, [](Location& l) { l.setCeiling(20.0); });
  EXPECT_NEAR(below.tip.z(), 0.0, 0.05);
  EXPECT_TRUE(below.under_scan);
  EXPECT_FALSE(below.collision.found());
  const ToolLocation holder = underRoof(25.0, [](Location& l) { // the holder reaches through the roof
    l.setCeiling(20.0);
    l.setHolder({ToolSegment::cylinder(4.0, 20.0, "shank"), ToolSegment::cylinder(9.0, 30.0, "chuck")});
  });
  EXPECT_NEAR(holder.tip.z(), 0.0, 0.05);
  ASSERT_TRUE(holder.collision.found());
  EXPECT_EQ(holder.collision.part, ToolPart::Holder);
  EXPECT_NEAR(holder.collision.place.z(), 25.0, 1e-5);
  EXPECT_FALSE(holder.under_scan) << "the chuck ends above the roof";
  EXPECT_FALSE(underRoof(25.0, [](Location& l) { l.setHolder({ToolSegment::cylinder(4.0, 10.0, "shank")}); }).collision.found());
}

/** Posts of any height: those above the ceiling are found in the cutter, where the ones below lifted it. */
TEST(LocationCeiling, WhatIsAboveItAndInTheCutterIsFound)
{
  constexpr double ceiling = 12.0, R = 4.0, r = 1.5;
  Random random(6);
  const Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 4000; ++i)
    cloud->emplace_back(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform() < 0.9 ? 0.0 : random.uniform(0, 24));
  DrivePoints drive;
  for (int i = 0; i < 400; ++i)
    drive.push_back({{random.uniform(-35, 35), random.uniform(-35, 35), 0.0}, up, up});
  Location location;
  location.setInputCloud(cloud);
  location.setEvaluation(Evaluation::Points);
  location.setCutter(CutterShape::bullNose(R, r, 8.0));
  location.setCeiling(ceiling);
  location.setDrivePoints(drive);
  ToolLocations found;
  location.compute(found);
  ASSERT_EQ(found.size(), drive.size()) << location.getStatus().message();
  const CutterProfile profile(location.getCutter());
  std::size_t cutter = 0, shank = 0, none = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    double depth = 0.0, at = 0.0;
    for (const pcl::PointXYZ& p : *cloud) {
      const double l = std::hypot(p.x - found[i].tip.x(), p.y - found[i].tip.y()), h = p.z - found[i].tip.z();
      if (p.z <= ceiling) {
        ASSERT_FALSE(profile.contains(l, h, 1e-5)) << i;
        continue;
      }
      const double inside = h < r ? r - std::hypot(l - (R - r), h - r) : R - l; // of the corner, of the cylinder
      if (h >= 0.0 && h <= ceiling && l >= R - r && inside > depth) {
        depth = inside;
        at = h;
      }
      else if (h >= 0.0 && h <= ceiling && l < R - r)
        depth = std::max(depth, 10.0); // in the middle: at least found
    }
    if (depth > 0.02)
      EXPECT_TRUE(found[i].collision.found()) << i << ' ' << depth;
    if (depth == 0.0)
      EXPECT_FALSE(found[i].collision.found()) << i;
    if (depth > 0.02 && depth < 9.0) {
      EXPECT_NEAR(found[i].collision.depth, depth, 5e-3) << i << ' ' << at;
      EXPECT_EQ(found[i].collision.segment, -1);
    }
    (found[i].collision.part == ToolPart::Cutter ? cutter : found[i].collision.part == ToolPart::Shank ? shank : none) += 1;
  }
  EXPECT_GT(cutter, 20u);
  EXPECT_GT(shank, 5u);
  EXPECT_GT(none, 50u);
  EXPECT_EQ(location.getReport().collisions, cutter + shank);
}

TEST(LocationCeiling, OneBelowTheCutterIsRefused)
{
  Location location;
  location.setInputCloud(plates(25.0));
  location.setCutter(CutterShape::ball(4.0, 6.0));
  location.setDrivePoints({{{0, 0, 0}, up, up}});
  location.setEvaluation(Evaluation::Points);
  location.setCeiling(9.0);
  ToolLocations found;
  location.compute(found);
  EXPECT_TRUE(found.empty());
  EXPECT_NE(location.getStatus().message().find("the cutter is 10 mm high"), std::string::npos) << location.getStatus().message();
  location.setCeiling(10.0);
  location.compute(found);
  EXPECT_EQ(found.size(), 1u);
}

} // namespace location_ceiling_test
