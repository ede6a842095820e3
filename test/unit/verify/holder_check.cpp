// SPDX-License-Identifier: BSD-3-Clause
// Shank and holder along a path: walls by hand, random scenes by brute force, and the same scene moved and in another order.
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/verify/holder_check.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/machine_way.h"
#include "support/plain_mesh.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace holder_check_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Check = HolderCheck<pcl::PointXYZ>;

/** A tool whose holder begins at the top of the flank. */
struct Tool {
  CutterShape cutter;
  std::vector<ToolSegment> holder;
  double clearance = 0.0;
  double tolerance = 0.01;
  unsigned int threads = 0;
};

Check
checkOf(const Tool& tool)
{
  Check check;
  check.setCutter(tool.cutter);
  check.setHolder(tool.holder);
  check.setHolderClearance(tool.clearance);
  check.setTolerance(tool.tolerance);
  check.setNumberOfThreads(tool.threads);
  return check;
}

LeadReport
figures(const Cloud& cloud, const Tool& tool, const std::vector<ToolPoses>& passes)
{
  Check check = checkOf(tool);
  check.setInputCloud(pcl::make_shared<Cloud>(cloud));
  check.compute(passes);
  EXPECT_TRUE(check.getStatus().ok()) << check.getStatus().message();
  return check.getReport();
}

/** An upright tool over the floor z = 0, along y. */
ToolPoses
alongTheWall(int moves = 40)
{
  ToolPoses poses;
  for (int i = 0; i <= moves; ++i) {
    ToolPose pose;
    pose.contact = pose.tip = {0.0, -10.0 + 20.0 * i / moves, 0.0};
    poses.push_back(pose);
  }
  return poses;
}

/** A floor, and a wall 60 mm high at \p x. */
Cloud
floorAndWall(float x)
{
  Cloud cloud;
  for (int i = -60; i <= 60; ++i)
    for (int k = 0; k <= 120; ++k) {
      cloud.push_back({x, 0.25f * static_cast<float>(i), 0.5f * static_cast<float>(k)});
      cloud.push_back({x - 0.5f * static_cast<float>(k), 0.25f * static_cast<float>(i), 0.0f});
    }
  return cloud;
}

/** Radius of the solid above the cutting edge at \p height over the tip, by its own reckoning; -1 where there is none. */
double
radiusAt(const Tool& tool, double height)
{
  const CutterShape& c = tool.cutter; // a ball: the cylinder above its centre, then the holder
  double base = c.radius;
  if (height >= base && (tool.holder.empty() || height <= base + c.flank_length))
    return c.radius;
  base += c.flank_length;
  for (const ToolSegment& s : tool.holder) {
    if (height >= base && height <= base + s.length)
      return s.lower_radius + (s.upper_radius - s.lower_radius) * (height - base) / s.length;
    base += s.length;
  }
  return -1.0;
}

/** The largest distance of a point of \p cloud from the outside of the tool, on dense samples of a move; 0 if none is inside. */
double
bruteDepth(const Cloud& cloud, const Tool& tool, const ToolPose& from, const ToolPose& to)
{
  const int samples = 1 + static_cast<int>(std::ceil((to.tip - from.tip).norm() / 0.02 + angleBetween(from.axis, to.axis) / 0.0005));
  double deepest = 0.0;
  for (int s = 0; s <= samples; ++s) {
    const ToolPose pose = between(from, to, static_cast<double>(s) / samples);
    for (const pcl::PointXYZ& point : cloud) {
      const Vector3d way = point.getVector3fMap().cast<double>() - pose.tip;
      const double up = way.dot(pose.axis), l = (way - up * pose.axis).norm();
      if (radiusAt(tool, up) <= l)
        continue;
      double out = std::numeric_limits<double>::infinity();
      for (double h = up - 30.0; h <= up + 30.0; h += 0.04) // the nearest place of the outside
        out = std::min(out, std::hypot(std::max(0.0, radiusAt(tool, h) - l), h - up));
      deepest = std::max(deepest, out);
    }
  }
  return deepest;
}

} // namespace

TEST(HolderCheck, AWallBesideThePathIsMetAsDeepAsItStands)
{
  const std::vector<ToolPoses> passes{alongTheWall()};
  const Tool thin{CutterShape::ball(3.0, 5.0), {ToolSegment::cylinder(3.0, 10.0, "shank"), {4.0, 9.0, 20.0, "chuck"}}};
  for (const double wall : {3.5, 6.0, 8.99, 9.02}) {
    const LeadReport found = figures(floorAndWall(static_cast<float>(wall)), thin, passes);
    const double slant = std::hypot(20.0, 5.0) / 20.0; // the chuck is a cone: its top is met, the way out is square to its flank
    EXPECT_EQ(found.moves, 40U);
    EXPECT_EQ(found.collided > 0, wall < 9.0 - 0.01) << wall;
    if (found.collided == 0)
      continue;
    EXPECT_EQ(found.collided, 40U);
    EXPECT_EQ(found.deepest.part, ToolPart::Holder);
    EXPECT_EQ(found.deepest.segment, 1);
    EXPECT_NEAR(found.deepest.depth, (9.0 - wall) / slant, 1e-5);
    EXPECT_NEAR(found.deepest.place.x(), wall, 1e-5);
    EXPECT_NEAR(found.deepest.place.z(), 38.0, 1e-5);
    EXPECT_EQ(found.deepest.section, BlockSection::Cut);
  }
  Tool kept = thin;
  kept.clearance = 0.5;
  EXPECT_GT(figures(floorAndWall(9.4f), kept, passes).collided, 0U);
  EXPECT_EQ(figures(floorAndWall(9.6f), kept, passes).collided, 0U);
}

TEST(HolderCheck, TheShankEndsAtTheHolderAndWithoutOneNowhere)
{
  const std::vector<ToolPoses> passes{alongTheWall()};
  const Tool neck{CutterShape::ball(3.0, 5.0), {ToolSegment::cylinder(2.0, 60.0, "neck")}};
  const Cloud wall = floorAndWall(2.6f);
  const LeadReport found = figures(wall, neck, passes);
  EXPECT_EQ(found.deepest.part, ToolPart::Shank);
  EXPECT_NEAR(found.deepest.depth, 0.4, 1e-5);
  EXPECT_LE(found.deepest.place.z(), 8.0 + 1e-5);
  Cloud above; // what stands above the flank, over the floor
  for (const pcl::PointXYZ& p : wall)
    if (p.z == 0.0f || p.z > 8.1f)
      above.push_back(p);
  EXPECT_EQ(figures(above, neck, passes).collided, 0U) << "the neck passes";
  EXPECT_NEAR(figures(above, {CutterShape::ball(3.0, 5.0), {}}, passes).deepest.depth, 0.4, 1e-5);
  Cloud below; // the ball's own business
  for (const pcl::PointXYZ& p : wall)
    if (p.z < 2.9f)
      below.push_back(p);
  EXPECT_EQ(figures(below, neck, passes).collided, 0U);
  EXPECT_EQ(figures(wall, {CutterShape::flatEnd(2.5), {}}, passes).collided, 0U);
  EXPECT_GT(figures(wall, {CutterShape::flatEnd(2.7), {}}, passes).collided, 0U);
}

/** Of two poses far apart neither touches the post between them. */
TEST(HolderCheck, AMoveDoesNotJumpOverAPost)
{
  Cloud post;
  for (int k = 0; k <= 20; ++k)
    post.push_back({9.0f, 0.0f, 30.0f + static_cast<float>(k)});
  const Tool tool{CutterShape::ball(3.0, 5.0), {ToolSegment::cylinder(10.0, 30.0, "chuck")}};
  ToolPoses far = alongTheWall(1);
  far[0].tip.y() = -100.0;
  far[1].tip.y() = 100.0;
  const LeadReport found = figures(post, tool, {far});
  EXPECT_EQ(found.collided, 1U);
  EXPECT_NEAR(found.deepest.tip.y(), 0.0, 5.0) << "a chord of the chuck";
  EXPECT_EQ(figures(post, {tool.cutter, {ToolSegment::cylinder(8.9, 30.0, "chuck")}}, {far}).collided, 0U);
  EXPECT_EQ(figures(post, tool, {{far[0], far[0]}, {far[1], far[1]}}).collided, 0U) << "lifts are no cuts";
}

TEST(HolderCheck, FindsWhatDenseSamplesFind)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const ToolPoses spiral = domeSpiral(80.0, 3.0, 5, 40, 4.0, 25.0);
  const std::vector<ToolPoses> passes{ToolPoses(spiral.begin(), spiral.begin() + 90), ToolPoses(spiral.begin() + 110, spiral.end())};
  std::size_t hit = 0, free = 0, shanks = 0;
  for (int scene = 0; scene < 24; ++scene) {
    Tool tool{CutterShape::ball(4.0, 8.0), {{4.0, 6.0, 10.0, "cone"}, ToolSegment::cylinder(11.0, 9.0, "nut"), {11.0, 7.0, 9.0, "chuck"}}};
    tool.tolerance = 0.15;
    if (scene % 4 == 3)
      tool.holder.clear();
    Cloud cloud;
    for (int i = 0; i < 3; ++i)
      cloud.push_back({static_cast<float>(45.0 * unit(random)), static_cast<float>(45.0 * unit(random)),
                       static_cast<float>(20.0 + 24.0 * unit(random))});
    const LeadReport found = figures(cloud, tool, passes);
    std::size_t surely = 0, perhaps = 0, moves = 0;
    double deepest = 0.0;
    for (const ToolPoses& pass : passes)
      for (std::size_t i = 1; i < pass.size(); ++i, ++moves) {
        const double depth = bruteDepth(cloud, tool, pass[i - 1], pass[i]);
        surely += depth > tool.tolerance + 0.1; // half a step may be missed, and the samples are as coarse
        perhaps += depth > 0.0;
        deepest = std::max(deepest, bruteDepth(cloud, tool, pass[i], pass[i]));
      }
    EXPECT_EQ(found.moves, moves);
    EXPECT_GE(found.collided, surely) << scene;
    EXPECT_LE(found.collided, perhaps) << scene;
    if (deepest > tool.tolerance) {
      EXPECT_GE(found.deepest.depth, deepest - 0.04) << scene << ": the way out through the flank is no shorter";
    }
    hit += surely > 0;
    shanks += surely > 0 && found.deepest.part == ToolPart::Shank;
    free += perhaps == 0;
  }
  EXPECT_GT(hit, 8U);
  EXPECT_GT(shanks, 2U);
  EXPECT_GT(free, 2U);
}

TEST(HolderCheck, TheSameMovedInAnotherOrderAndOnAnyNumberOfThreads)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const std::vector<ToolPoses> passes{domeSpiral(80.0, 2.0, 8, 60, 4.0, 25.0)};
  Tool tool{CutterShape::ball(4.0, 8.0), {ToolSegment::cylinder(12.0, 20.0, "chuck")}};
  Cloud cloud;
  for (int i = 0; i < 40; ++i)
    cloud.push_back(
        {static_cast<float>(60.0 * unit(random)), static_cast<float>(60.0 * unit(random)), static_cast<float>(25.0 + 30.0 * unit(random))});
  const LeadReport found = figures(cloud, tool, passes);
  ASSERT_GT(found.collided, 20U);
  ASSERT_LT(found.collided, found.moves - 20U);
  tool.threads = 1;
  Cloud other = cloud;
  std::shuffle(other.begin(), other.end(), random);
  const LeadReport again = figures(other, tool, passes);
  EXPECT_EQ(again.collided, found.collided);
  EXPECT_EQ(again.deepest.depth, found.deepest.depth);
  EXPECT_EQ(again.deepest.block, found.deepest.block);
  EXPECT_EQ(again.deepest.place, found.deepest.place);
  for (int motion = 0; motion < 3; ++motion) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
    const Vector3d shift(40.0 * unit(random), 40.0 * unit(random), 40.0 * unit(random));
    std::vector<ToolPoses> moved = passes;
    for (ToolPose& pose : moved[0]) {
      pose.tip = turn * pose.tip + shift;
      pose.axis = turn * pose.axis;
    }
    Cloud there;
    for (const pcl::PointXYZ& p : cloud) {
      const Vector3d place = turn * p.getVector3fMap().cast<double>() + shift;
      there.push_back({static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())});
    }
    const LeadReport same = figures(there, tool, moved);
    EXPECT_NEAR(same.deepest.depth, found.deepest.depth, 1e-4);
    EXPECT_EQ(same.deepest.block, found.deepest.block);
    EXPECT_NEAR(static_cast<double>(same.collided), static_cast<double>(found.collided), 1.0) << "one at the tolerance may change";
  }
}

/** The machine blends the axis at its pole; what it then does is told by the oracle's kinematics, sample by sample. */
TEST(HolderCheck, ABlendedAxisIsLookedAtAsTheMachineTurnsIt)
{
  constexpr double ball = 5.0, tolerance = 0.05;
  const Tool tool{CutterShape::ball(ball, 20.0), {ToolSegment::cylinder(12.0, 60.0, "chuck")}, 0.0, tolerance};
  ToolPoses poses; // straight over a dome, 0.5 mm beside its pole
  for (int i = -150; i <= 150; ++i) {
    ToolPose pose;
    const double x = 0.1 * i / 200.0, y = 0.5 / 200.0;
    pose.normal = pose.axis = Vector3d(x, y, std::sqrt(1.0 - x * x - y * y));
    pose.contact = pose.tip = 200.0 * pose.normal;
    poses.push_back(pose);
  }
  std::size_t only_blended = 0;
  for (Machine machine : testMachines()) {
    machine.rotary[0].range.largest_rate = 8.0 * 2.0 * M_PI;
    MachineProgramGenerator generator;
    generator.setMachine(machine);
    generator.setInputPoses(poses);
    ProgramSettings settings;
    settings.ball_radius = ball;
    MachineProgram programs[2];
    for (int k = 0; k < 2; ++k) {
      settings.pole_cone = k == 0 ? 5.0 : 0.0;
      generator.setSettings(settings);
      generator.compute(programs[k]);
      ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    }
    ASSERT_EQ(programs[0].report.poles.size(), 1U);
    for (const double beside : {-1.0, 0.3, 0.8, 5.0}) { // a row of points beside the highest ring of the chuck
      Cloud cloud;
      for (int i = -300; i <= 300; ++i)
        for (const float side : {-1.0f, 1.0f})
          cloud.push_back({0.05f * static_cast<float>(i), side * static_cast<float>(12.0 + beside), 284.0f});
      double brute[2] = {0.0, 0.0};
      for (int k = 0; k < 2; ++k)
        for (std::size_t i = 1; i < programs[k].blocks.size(); ++i)
          for (int s = 0; programs[k].blocks[i].section == BlockSection::Cut && s <= 4; ++s) {
            const TipAndAxis at = onTheWay(machine, programs[k].blocks[i - 1], programs[k].blocks[i], s / 4.0);
            for (const pcl::PointXYZ& point : cloud) {
              const Vector3d way = point.getVector3fMap().cast<double>() - at.tip;
              const double up = way.dot(at.axis);
              if (up > 25.0 && up < 85.0)
                brute[k] = std::max(brute[k], 12.0 - (way - up * at.axis).norm());
            }
          }
      for (int k = 0; k < 2; ++k) {
        Check check = checkOf(tool);
        check.setInputCloud(pcl::make_shared<Cloud>(cloud));
        check.compute(programs[k]);
        ASSERT_TRUE(check.getStatus().ok()) << check.getStatus().message();
        const LeadReport& found = check.getReport();
        if (std::abs(brute[k] - tolerance) > 0.05) {
          EXPECT_EQ(found.collided > 0, brute[k] > tolerance) << machine.name << " beside " << beside << ": " << brute[k];
        }
        if (found.collided == 0)
          continue;
        EXPECT_NEAR(found.deepest.depth, brute[k], 0.05) << machine.name;
        EXPECT_EQ(programs[k].blocks[found.deepest.block].section, BlockSection::Cut);
        EXPECT_LT((programs[k].blocks[found.deepest.block].tip - found.deepest.tip).norm(), 1.0) << "the number of its block";
      }
      only_blended += brute[0] > tolerance + 0.05 && brute[1] < tolerance;
    }
  }
  EXPECT_GT(only_blended, 3U) << "points that only the blended tool touches";
}

/** A wall of two triangles has no vertex near the tool. */
TEST(HolderCheck, AMeshIsLookedAtBetweenItsVertices)
{
  const std::vector<ToolPoses> passes{alongTheWall()};
  for (const double wall : {8.0, 11.0}) {
    PlainMesh mesh;
    mesh.addQuad({-300, -300, 0}, {300, -300, 0}, {300, 300, 0}, {-300, 300, 0});
    mesh.addQuad({wall, -500, -500}, {wall, -500, 500}, {wall, 500, 500}, {wall, 500, -500});
    Check check =
        checkOf({CutterShape::ball(3.0, 5.0), {ToolSegment::cylinder(3.0, 10.0, "shank"), ToolSegment::cylinder(10.0, 30.0, "chuck")}});
    check.setInputMesh(mesh.surface());
    check.compute(passes);
    ASSERT_TRUE(check.getStatus().ok()) << check.getStatus().message();
    const LeadReport& found = check.getReport();
    EXPECT_EQ(found.collided, wall < 10.0 ? 40U : 0U);
    if (wall > 10.0)
      continue;
    EXPECT_NEAR(found.deepest.depth, 2.0, 2e-3);
    EXPECT_EQ(found.deepest.segment, 1);
  }
}

TEST(HolderCheck, SinglePointsInTheAirAreNoObstacles)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<float> jitter(-0.1f, 0.1f);
  const Tool tool{CutterShape::ball(3.0, 5.0), {ToolSegment::cylinder(10.0, 30.0, "chuck")}};
  for (const int points : {0, 1, 6}) {
    Cloud cloud;
    for (int i = -50; i <= 50; ++i)
      for (int k = -50; k <= 50; ++k)
        cloud.push_back({0.5f * static_cast<float>(i) + jitter(random), 0.5f * static_cast<float>(k) + jitter(random), 0.0f});
    for (int i = 0; i < points; ++i)
      cloud.push_back({9.0f, 0.4f * static_cast<float>(i), 20.0f});
    Check check = checkOf(tool);
    check.setInputCloud(pcl::make_shared<Cloud>(cloud));
    check.setLargestEcho(largest_echo);
    check.compute({alongTheWall()});
    EXPECT_EQ(check.getReport().collided > 0, points > 0);
    EXPECT_EQ(check.getObstacleReport().collided > 0, points > 3);
  }
}

TEST(HolderCheck, RefusesWhatCannotBe)
{
  const auto message = [&](const std::function<void(Check&)>& spoil, std::vector<ToolPoses> passes = {alongTheWall()}) {
    Check check = checkOf({CutterShape::ball(3.0), {}});
    check.setInputCloud(pcl::make_shared<Cloud>(floorAndWall(9.0f)));
    spoil(check);
    check.compute(passes);
    EXPECT_FALSE(check.getStatus().ok());
    EXPECT_EQ(check.getReport().moves, 0U);
    return check.getStatus().message();
  };
  const auto expectHas = [](const std::string& text, const char* part) { EXPECT_NE(text.find(part), std::string::npos) << text; };
  const auto nothing = [](Check&) {};
  expectHas(message([](Check& c) { c.setInputCloud(pcl::make_shared<Cloud>()); }), "empty");
  expectHas(message([](Check& c) { c.setCutter(CutterShape()); }), "radius");
  expectHas(message([](Check& c) { c.setTolerance(0.0); }), "tolerance is 0");
  expectHas(message([](Check& c) { c.setProgressCallback([](double, const std::string&) { return false; }); }), "cancelled");
  expectHas(message(nothing, {}), "no pass has a move");
  ToolPoses bent = alongTheWall();
  bent[3].axis *= 2.0;
  expectHas(message(nothing, {bent}), "pose 3 is not finite or its axis is not a unit vector");
  Check check = checkOf({CutterShape::ball(3.0), {}});
  check.setInputCloud(pcl::make_shared<Cloud>(floorAndWall(9.0f)));
  MachineProgram none;
  none.machine = xyzacTrunnion();
  check.compute(none);
  expectHas(check.getStatus().message(), "no cutting moves");
}

} // namespace holder_check_test
