// SPDX-License-Identifier: BSD-3-Clause
// A path at constant scallop height composed by hand is byte for byte that of the generator; closed loops are another toolpath.
#include "support/outlines.h"
#include "support/sampling.h"

#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <cmath>

namespace scallop_stages_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Path = pcl::PointCloud<ToolpathPoint>;

SpiralSettings
settings(unsigned int threads = 0)
{
  SpiralSettings s;
  s.method = SpiralMethod::ConstantScallop;
  s.tool_radius = 5.0;
  s.scallop_height = 0.1;
  s.chord_error = 0.01;
  s.threads = threads;
  return s;
}

Cloud::Ptr
part(const char* outline)
{
  return toCloud(sampleUniform(*outlinedPart(outline, 0, 0.5), 5000, 3).points);
}

/** A flat part with a gap in its data, too small for a hole of the part. */
Cloud::Ptr
partWithGap()
{
  Cloud::Ptr cloud(new Cloud);
  for (const Vector3d& p : sampleUniform(*flat(Region({rectangle(90.0, 60.0)})), 6000, 4).points)
    if ((p.head<2>() - Eigen::Vector2d(20.0, 8.0)).norm() > 3.5)
      cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

template <typename Stage>
void
expectDone(const Stage& stage)
{
  EXPECT_TRUE(stage.getStatus().ok()) << stage.getStatus().message();
}

/** The data between the stages, without the generator. */
struct ByHand {
  Surface::ConstPtr surface;
  std::vector<BoundaryLoop> rims;
  StepOverDistance::ConstPtr field;
  ScallopLoopSet loops;
  LinkedPath linked;
  ScallopReport figures;
  SpiralPath path;
};

template <typename Stage>
void
setUp(const ByHand& by_hand, const SpiralSettings& s, Stage& stage)
{
  stage.setInputSurface(by_hand.surface);
  stage.setBoundaryLoops(by_hand.rims);
  stage.setToolRadius(s.tool_radius);
  stage.setScallopHeight(s.scallop_height);
  stage.setNumberOfThreads(s.threads);
}

void
makeLoops(const SpiralSettings& s, ByHand& by_hand)
{
  StepOverField<Point> distances;
  setUp(by_hand, s, distances);
  distances.compute(by_hand.field);
  expectDone(distances);
  ScallopLoops<Point> loops;
  loops.setInputField(by_hand.field);
  loops.setNumberOfThreads(s.threads);
  loops.compute(by_hand.loops);
  expectDone(loops);
}

ByHand
composed(const Cloud::ConstPtr& cloud, const SpiralSettings& s)
{
  ByHand by_hand;
  GapBridging<Point> bridging;
  bridging.setInputCloud(cloud);
  bridging.setBoundaryMode(BoundaryMode::AllBoundaries);
  bridging.setNumberOfThreads(s.threads);
  bridging.compute(by_hand.surface, by_hand.rims);
  expectDone(bridging);
  makeLoops(s, by_hand);

  LoopLinking<Point> linking;
  linking.setInputField(by_hand.field);
  linking.setInputLoops(by_hand.loops.loops);
  linking.setDirection(s.direction);
  linking.setSense(s.sense);
  linking.setOneWay(s.one_way);
  linking.setNumberOfThreads(s.threads);
  linking.compute(by_hand.linked);
  expectDone(linking);
  by_hand.figures = linking.getReport();

  SpiralTurns turns;
  EXPECT_TRUE(samplePath(by_hand.linked, *by_hand.surface, s, turns).ok());
  GapReport gaps;
  EXPECT_TRUE(putOnSurface(turns, *by_hand.surface, s, {}, by_hand.path, gaps).ok());
  AxisReport axes;
  pcl_spiral::Diagnostics warnings;
  EXPECT_TRUE(setToolAxes(s, by_hand.path, axes, warnings).ok());
  ToolpathReport figures;
  EXPECT_TRUE(checkPath(by_hand.path, s, turns.largest_allowed_step, {}, figures).ok());
  return by_hand;
}

void
expectSame(const SpiralPath& by_hand, const Path& path)
{
  ASSERT_GT(path.size(), 500u);
  ASSERT_EQ(by_hand.contacts.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(by_hand.contacts[i].cast<float>(), path[i].getVector3fMap()) << i;
    ASSERT_EQ(by_hand.normals[i].cast<float>(), path[i].getNormalVector3fMap()) << i;
    ASSERT_EQ(by_hand.axes[i], path[i].getAxisVector3fMap()) << i;
    ASSERT_EQ(by_hand.arc_lengths[i], path[i].arc_length) << i;
    ASSERT_EQ(by_hand.turns[i], path[i].turn) << i;
    ASSERT_EQ(by_hand.over_gap[i], path[i].over_gap) << i;
  }
}

void
expectByHandAndInOneCallTheSame(const Cloud::ConstPtr& cloud, const SpiralSettings& s)
{
  SpiralToolpathGenerator<Point> spiral;
  spiral.setInputCloud(cloud);
  spiral.setSettings(s);
  Path path;
  spiral.compute(path);
  expectDone(spiral);
  const ByHand by_hand = composed(cloud, s);
  expectSame(by_hand.path, path);
  EXPECT_EQ(by_hand.figures.bridges, spiral.getReport().bridges);
  EXPECT_EQ(by_hand.figures.reversed_share, spiral.getReport().reversed_share);
  EXPECT_EQ(by_hand.path.passes, spiral.getPassBegins());
  EXPECT_EQ(by_hand.figures.lifts, spiral.getPassBegins().size());
  EXPECT_EQ(by_hand.figures.lift_length, spiral.getReport().lift_length);
  EXPECT_EQ(by_hand.figures.least_length, spiral.getReport().least_length);
  EXPECT_EQ(by_hand.loops.axes.size(), spiral.getReport().fingers);
}

class ScallopStages : public testing::Test {
protected:
  ScallopStages() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
};

} // namespace

TEST_F(ScallopStages, ByHandAndInOneCallTheSameBytes)
{
  for (const char* outline : {"disc", "L", "ring", "holes_2"}) {
    SCOPED_TRACE(outline);
    for (const unsigned int threads : {1u, 3u})
      expectByHandAndInOneCallTheSame(part(outline), settings(threads));
  }
  expectByHandAndInOneCallTheSame(partWithGap(), settings());
  SpiralSettings s = settings();
  s.direction = SpiralDirection::Inward;
  s.sense = SpiralSense::Clockwise;
  expectByHandAndInOneCallTheSame(part("holes_2"), s);
  s = settings();
  s.one_way = true;
  for (s.threads = 1; s.threads <= 3; s.threads += 2)
    expectByHandAndInOneCallTheSame(part("holes_2"), s);
}

TEST_F(ScallopStages, WhatIsNotGivenIsMadeByTheSameRules)
{
  const auto cloud = part("L");
  const ByHand by_hand = composed(cloud, settings());
  LoopLinking<Point> linking;
  linking.setInputCloud(cloud);
  linking.setToolRadius(5.0);
  linking.setScallopHeight(0.1);
  LinkedPath of_cloud, of_surface, of_field, of_loops;
  linking.compute(of_cloud);
  expectDone(linking);
  linking.setInputSurface(by_hand.surface);
  linking.compute(of_surface);
  expectDone(linking);
  linking.setInputField(by_hand.field);
  linking.compute(of_field);
  EXPECT_EQ(linking.getReport().fingers, by_hand.loops.axes.size());
  linking.setInputLoops(by_hand.loops.loops);
  linking.compute(of_loops);
  for (const LinkedPath* path : {&of_cloud, &of_surface, &of_field, &of_loops})
    EXPECT_EQ(path->points, by_hand.linked.points);
  linking.setInputCloud(part("disc")); // loops and field are dropped
  linking.compute(of_cloud);
  EXPECT_EQ(linking.getReport().bridges, 0u);
}

TEST_F(ScallopStages, LoopsAloneAreLinked)
{
  const ByHand by_hand = composed(part("L"), settings());
  LoopLinking<Point> linking;
  linking.setInputLoops(by_hand.loops.loops);
  LinkedPath path;
  linking.compute(path);
  expectDone(linking);
  EXPECT_NEAR(length(path.points), length(by_hand.linked.points), 0.01 * length(path.points));
  EXPECT_EQ(linking.getReport().least_length, 0.0);
}

TEST_F(ScallopStages, ClosedLoopsAreAToolpath)
{
  const ByHand by_hand = composed(part("holes_2"), settings());
  ScallopLoops<Point> loops;
  setUp(by_hand, settings(), loops);
  DrivePasses of_surface, passes;
  loops.compute(of_surface);
  expectDone(loops);
  loops.setInputField(by_hand.field);
  loops.setTiltAngle(10.0);
  loops.compute(passes);
  expectDone(loops);
  ASSERT_EQ(passes.size(), by_hand.loops.loops.size());
  ASSERT_EQ(passes.size(), of_surface.size());
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const DrivePoints& points = passes[i].points;
    EXPECT_TRUE(passes[i].closed);
    ASSERT_GT(points.size(), 3u);
    EXPECT_EQ(points.size(), of_surface[i].points.size());
    EXPECT_LT((points[0].position - by_hand.loops.loops[i].points[0]).norm(), 0.2);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double move = (points[(k + 1) % points.size()].position - points[k].position).norm();
      EXPECT_GT(move, 1e-6);
      EXPECT_LT(move, 5.0 * 1.05);
      EXPECT_NEAR(points[k].axis.dot(points[k].normal), std::cos(10.0 * M_PI / 180.0), 1e-6);
    }
  }
}

TEST_F(ScallopStages, ClosedLoopsGoTheWayAskedForAndOnToTheCutter)
{
  const auto cloud = part("ring");
  ScallopLoops<Point> loops;
  loops.setInputCloud(cloud);
  loops.setToolRadius(5.0);
  loops.setScallopHeight(0.1);
  DrivePasses passes, back;
  loops.compute(passes);
  loops.setSense(SpiralSense::Clockwise);
  loops.compute(back);
  expectDone(loops);
  ASSERT_EQ(back.size(), passes.size());
  const auto area = [](const DrivePass& pass) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pass.points.size(); ++i) {
      const Vector3d &a = pass.points[i].position, &b = pass.points[(i + 1) % pass.points.size()].position;
      sum += 0.5 * (a.x() * b.y() - b.x() * a.y());
    }
    return sum;
  };
  EXPECT_GT(area(passes[0]), 0.0); // the outer rim
  EXPECT_LT(area(passes[1]), 0.0); // the loop of the hole
  for (std::size_t i = 0; i < passes.size(); ++i)
    EXPECT_NEAR(area(back[i]), -area(passes[i]), 0.01 * std::abs(area(passes[i])));

  CutterLocation<Point> location; // then further, to programs
  location.setInputCloud(cloud);
  location.setDrivePasses(passes);
  location.setCutter(CutterShape::ball(5.0));
  std::vector<ToolLocations> located;
  location.compute(located);
  EXPECT_EQ(located.size(), passes.size()) << location.getStatus().message();
}

} // namespace scallop_stages_test
