// SPDX-License-Identifier: BSD-3-Clause
// Moves off the path against a scan: a wall beside the path by hand, random scenes by brute force with the oracle's kinematics.
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/verify/lead_check.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/machine_way.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace lead_check_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

MachineProgram
made(const Machine& machine, const std::vector<ToolPoses>& passes, const ProgramSettings& settings)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses(passes);
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

LeadReport
figures(const Cloud::ConstPtr& cloud, const CutterShape& cutter, const MachineProgram& program, double tolerance,
        const std::vector<ToolSegment>& holder = {}, int threads = 0)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(cloud);
  check.setCutter(cutter);
  check.setHolder(holder);
  check.setTolerance(tolerance);
  check.setNumberOfThreads(threads);
  check.compute(program);
  EXPECT_TRUE(check.getStatus().ok()) << check.getStatus().message();
  return check.getReport();
}

/** Depth of the deepest point, on the move to \p block, in the cutter minus \p inset or in the shank above it, along the
 *  axis or across it; and in the holder. */
struct BruteDepth {
  double cutter = 0.0, holder = 0.0;
};

BruteDepth
bruteDepth(const Cloud& cloud, const CutterShape& shape, double inset, const HolderProfile& holder, const MachineProgram& program,
           std::size_t block)
{
  const CutterProfile cutter = insetCutter(CutterProfile(shape), inset);
  const ProgramBlock &a = program.blocks[block - 1], &b = program.blocks[block];
  const int samples = 1 + static_cast<int>(std::ceil((b.tip - a.tip).norm() / 0.05 + std::abs(b.angles.first - a.angles.first) / 0.002 +
                                                     std::abs(b.angles.second - a.angles.second) / 0.002));
  BruteDepth deepest;
  for (int s = 0; s <= samples; ++s) {
    const TipAndAxis tool = onTheWay(program.machine, a, b, static_cast<double>(s) / samples);
    for (const pcl::PointXYZ& point : cloud) {
      const Eigen::Vector3d way = point.getVector3fMap().cast<double>() - tool.tip;
      const double along = way.dot(tool.axis), across = (way - along * tool.axis).norm(), up = along - inset;
      if (across <= cutter.radius())
        deepest.cutter = std::max(deepest.cutter, std::min(up - cutter.height(across), cutter.radiusAt(up) - across));
      double depth = 0.0;
      if (!holder.empty() && holder.inside(across, along, depth) >= 0)
        deepest.holder = std::max(deepest.holder, depth);
    }
  }
  return deepest;
}

/** A path along -x over the floor z = 0 that begins at x = 0; the axis is upright, so tip and contact are the same. */
ToolPoses
overTheFloor()
{
  ToolPoses poses;
  for (int i = 0; i <= 10; ++i) {
    ToolPose pose;
    pose.contact = {-1.0 * i, 0.0, 0.0};
    pose.tip = pose.contact;
    pose.normal = pose.axis = Eigen::Vector3d::UnitZ();
    poses.push_back(pose);
  }
  return poses;
}

/** A wall at \p x, 20 mm high, over a floor. */
Cloud::Ptr
floorAndWall(float x)
{
  Cloud::Ptr cloud(new Cloud);
  for (int i = -40; i <= 40; ++i)
    for (int k = 0; k <= 40; ++k) {
      cloud->push_back({x, 0.25f * static_cast<float>(i), 0.5f * static_cast<float>(k)});
      cloud->push_back({x - 0.5f * static_cast<float>(k), 0.25f * static_cast<float>(i), 0.0f});
    }
  return cloud;
}

} // namespace

TEST(LeadCheck, AnArcAsWideAsTheRoomBeforeAWallIsFree)
{
  constexpr double ball = 3.0, tolerance = 0.02;
  const Machine machine = testMachines().front();
  for (const double lead : {1.0, 2.0, 4.0})
    for (const double room : {-0.5, -0.05, 0.05, 0.5}) {
      ProgramSettings settings;
      settings.ball_radius = ball;
      settings.lead = LeadKind::Arc;
      settings.lead_length = lead;
      const MachineProgram program = made(machine, {overTheFloor()}, settings);
      const LeadReport found = figures(floorAndWall(static_cast<float>(ball + lead + room)), CutterShape::ball(ball), program, tolerance);
      EXPECT_EQ(found.collided > 0, room < 0.0) << lead << " and " << room;
      if (room > 0.0)
        continue;
      EXPECT_NEAR(found.deepest.place.x(), ball + lead + room, 1e-5);
      EXPECT_EQ(found.deepest.segment, -1);
      EXPECT_NE(found.deepest.part, ToolPart::Holder);
      EXPECT_NEAR(found.deepest.depth, -room, 1e-5) << "the way out is sideways";
      const BlockSection section = program.blocks[found.deepest.block].section;
      EXPECT_EQ(found.deepest.section, section);
      EXPECT_TRUE(section == BlockSection::LeadIn || section == BlockSection::Approach);
    }
}

TEST(LeadCheck, AHolderMeetsTheWallThatTheCutterPasses)
{
  const MachineProgram program = made(testMachines().front(), {overTheFloor()}, ProgramSettings());
  const CutterShape cutter = CutterShape::ball(3.0, 5.0);
  const auto cloud = floorAndWall(6.0f);
  EXPECT_EQ(figures(cloud, cutter, program, 0.01).collided, 0U);
  EXPECT_EQ(figures(cloud, cutter, program, 0.01, {ToolSegment::cylinder(5.9, 30.0, "chuck")}).collided, 0U);
  const LeadReport found =
      figures(cloud, cutter, program, 0.01, {ToolSegment::cylinder(3.0, 4.0, "shank"), ToolSegment::cylinder(6.5, 30.0, "chuck")});
  EXPECT_GT(found.collided, 0U);
  EXPECT_EQ(found.deepest.segment, 1);
  EXPECT_NEAR(found.deepest.depth, 0.5, 1e-5) << "out through the side";
}

/** A nut moves straight down past a ledge: at both ends of the move it is free. */
TEST(LeadCheck, AHolderDoesNotJumpOverALedge)
{
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i <= 40; ++i)
    for (int k = -20; k <= 20; ++k)
      cloud->push_back({10.0f + 0.5f * static_cast<float>(i), 0.5f * static_cast<float>(k), 60.0f});
  ProgramSettings settings;
  settings.rapid_height = 45.0;
  const MachineProgram program = made(testMachines().front(), {overTheFloor()}, settings);
  const CutterShape cutter = CutterShape::ball(4.0, 16.0);
  EXPECT_EQ(figures(cloud, cutter, program, 0.02).collided, 0U);
  const LeadReport found = figures(cloud, cutter, program, 0.02, {ToolSegment::cylinder(15.0, 10.0, "nut")});
  EXPECT_GT(found.collided, 0U);
  EXPECT_EQ(found.deepest.part, ToolPart::Holder);
  EXPECT_NEAR(found.deepest.depth, 5.0, 0.06) << "15 less 10, or half of the nut's length";
}

/** Points above the dome, where leads and rapids of a tilted spiral pass, and as high as the shank and the holder. */
TEST(LeadCheck, FindsWhatDenseSamplesOfTheMachineFind)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const ToolPoses spiral = domeSpiral(80.0, 2.0, 8, 60, 4.0, 25.0);
  const std::vector<ToolPoses> passes{ToolPoses(spiral.begin(), spiral.begin() + 200), ToolPoses(spiral.begin() + 260, spiral.end())};
  constexpr double tolerance = 0.2;
  std::size_t hits = 0, holder_hits = 0, free = 0;
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false})
      for (const CutterShape& cutter :
           {CutterShape::ball(4.0, 10.0), CutterShape::flatEnd(4.0), CutterShape::taperedBullNose(6.0, 1.0, 12.0, 10.0)}) {
        machine.rtcp = rtcp;
        ProgramSettings settings;
        settings.ball_radius = 4.0;
        settings.lead = hits % 2 == 0 ? LeadKind::Normal : LeadKind::Arc;
        settings.rapid_height = 20.0;
        const MachineProgram program = made(machine, passes, settings);
        const bool high = (hits + free) % 2 == 0;
        std::vector<ToolSegment> segments;
        if (cutter.flank_length > 0.0)
          segments = {{4.0, 7.0, 12.0, "shank"}, ToolSegment::cylinder(12.0, 15.0, "chuck")};
        const CutterProfile profile(cutter);
        const HolderProfile holder(segments, profile.topHeight(), profile.radius(), 0.0);
        Cloud::Ptr cloud(new Cloud);
        for (int i = 0; i < 12; ++i)
          cloud->push_back({static_cast<float>(40.0 * unit(random)), static_cast<float>(40.0 * unit(random)),
                            static_cast<float>(high ? 90.0 + 70.0 * unit(random) : 12.0 + 14.0 * unit(random))});
        const LeadReport found = figures(cloud, cutter, program, tolerance, segments);
        std::size_t moves = 0, surely = 0, perhaps = 0;
        double deepest = 0.0;
        for (std::size_t i = 1; i < program.blocks.size(); ++i) {
          if (program.blocks[i].section == BlockSection::Cut)
            continue;
          ++moves;
          // Between the checked places a point may be deeper by half the tolerance.
          const BruteDepth more = bruteDepth(*cloud, cutter, 1.5 * tolerance, holder, program, i),
                           about = bruteDepth(*cloud, cutter, 0.8 * tolerance, holder, program, i);
          surely += more.cutter > 0.0 || more.holder > 1.5 * tolerance;
          perhaps += about.cutter > 0.0 || about.holder > 0.8 * tolerance;
          holder_hits += more.holder > 1.5 * tolerance && !(more.cutter > 0.0);
          deepest = std::max({deepest, about.cutter + tolerance, about.holder});
        }
        EXPECT_EQ(found.moves, moves);
        EXPECT_GE(found.collided, surely) << machine.name << (rtcp ? " rtcp " : " ") << found.collided;
        EXPECT_LE(found.collided, perhaps) << machine.name;
        EXPECT_LE(found.deepest.depth, deepest + 0.3) << machine.name;
        hits += surely > 0;
        free += perhaps == 0;
        const LeadReport one = figures(cloud, cutter, program, tolerance, segments, 1);
        EXPECT_EQ(one.collided, found.collided);
        EXPECT_EQ(one.deepest.depth, found.deepest.depth);
        EXPECT_EQ(one.deepest.block, found.deepest.block);
      }
  EXPECT_GT(hits, 5U);
  EXPECT_GT(holder_hits, 5U);
  EXPECT_GT(free, 2U);
}

/** A post as high as \p top, 2 mm wide, at (\p x, \p y). */
Cloud::Ptr
post(float x, float y, float top)
{
  Cloud::Ptr cloud(new Cloud);
  for (int corner = 0; corner < 4; ++corner)
    for (float z = 0.0f; z <= top; z += 1.0f)
      cloud->push_back({x + (corner % 2 ? 1.0f : -1.0f), y + (corner / 2 ? 1.0f : -1.0f), z});
  return cloud;
}

/** Between a pass that ends and one that begins, 80 mm apart, the tool crosses at the rapid height. */
TEST(LeadCheck, APostBetweenTwoPassesIsMet)
{
  ToolPoses second = overTheFloor();
  for (ToolPose& pose : second) {
    pose.contact.y() += 80.0;
    pose.tip = pose.contact;
  }
  ProgramSettings settings;
  settings.rapid_height = 20.0;
  for (const Machine& machine : testMachines()) {
    const MachineProgram program = made(machine, {overTheFloor(), second}, settings);
    const CutterShape cutter = CutterShape::ball(3.0, 10.0);
    double lowest = 1e9; // of the tip, over the post
    std::size_t between = 0;
    for (std::size_t i = 1; i < program.blocks.size(); ++i)
      for (int k = 0; k <= 200; ++k) {
        const TipAndAxis tool = onTheWay(machine, program.blocks[i - 1], program.blocks[i], k / 200.0);
        if (std::abs(tool.tip.y() - 40.0) < 1.0) {
          lowest = std::min(lowest, tool.tip.z());
          between = i;
        }
      }
    ASSERT_GT(between, 0U);
    const float x = -5.0f; // half the length of a pass: the way goes from the end of one to the beginning of the other
    EXPECT_EQ(figures(post(x, 40.0f, static_cast<float>(lowest) - 2.0f), cutter, program, 0.05).collided, 0U) << machine.name;
    const LeadReport met = figures(post(x, 40.0f, static_cast<float>(lowest) + 9.0f), cutter, program, 0.05);
    EXPECT_EQ(met.collided, 1U) << machine.name;
    EXPECT_EQ(met.deepest.block, between);
    EXPECT_EQ(met.deepest.section, BlockSection::Position);
    MachineProgram relabelled = program; // a rapid never cuts, whatever its section
    relabelled.blocks[between].section = BlockSection::Cut;
    EXPECT_EQ(figures(post(x, 40.0f, static_cast<float>(lowest) + 9.0f), cutter, relabelled, 0.05).collided, 1U);
  }
}

/** The first rotary axis turns back at the top, and the leaning tool swings round on the other side of its tip. */
TEST(LeadCheck, APostInTheSwingOfTheUnwindingToolIsMet)
{
  for (Machine machine : testMachines()) {
    machine.rotary[0].range.lower = -7.0;
    machine.rotary[0].range.upper = 8.0;
    ProgramSettings settings;
    settings.ball_radius = 4.0;
    MachineProgram program = made(machine, {domeSpiral(80.0, 2.0, 8, 60, 4.0, 25.0)}, settings);
    const auto first = std::find_if(program.blocks.begin(), program.blocks.end(),
                                    [](const ProgramBlock& block) { return block.section == BlockSection::Unwind; });
    ASSERT_NE(first, program.blocks.end()) << machine.name;
    const auto last =
        std::find_if(first, program.blocks.end(), [](const ProgramBlock& block) { return block.section != BlockSection::Unwind; });
    program.blocks = std::vector<ProgramBlock>(first - 1, last);
    const ProgramBlock &from = program.blocks[0], &to = program.blocks[1];
    const TipAndAxis swung = onTheWay(machine, from, to, 0.5);
    ASSERT_GT(angleBetween(swung.axis, from.axis), 0.1) << machine.name;
    const Eigen::Vector3d place = swung.tip + 60.0 * swung.axis;
    Cloud::Ptr clamp(new Cloud);
    clamp->push_back({static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())});
    const LeadReport met = figures(clamp, CutterShape::ball(4.0), program, 0.1);
    EXPECT_GE(met.collided, 1U) << machine.name;
    EXPECT_EQ(met.deepest.section, BlockSection::Unwind);
    EXPECT_EQ(met.moves, program.blocks.size() - 1);
  }
}

TEST(LeadCheck, RefusesWhatCannotBe)
{
  const MachineProgram program = made(testMachines().front(), {overTheFloor()}, ProgramSettings());
  const auto message = [&](const std::function<void(LeadCheck<pcl::PointXYZ>&)>& spoil) {
    LeadCheck<pcl::PointXYZ> check;
    check.setInputCloud(floorAndWall(9.0f));
    check.setCutter(CutterShape::ball(3.0));
    spoil(check);
    check.compute(program);
    EXPECT_FALSE(check.getStatus().ok());
    EXPECT_EQ(check.getReport().moves, 0U);
    return check.getStatus().message();
  };
  using Check = LeadCheck<pcl::PointXYZ>;
  const auto expectHas = [](const std::string& text, const char* part) { EXPECT_NE(text.find(part), std::string::npos) << text; };
  expectHas(message([](Check& c) { c.setInputCloud(Cloud::Ptr(new Cloud)); }), "empty");
  expectHas(message([](Check& c) {
              const float nan = std::numeric_limits<float>::quiet_NaN();
              Cloud::Ptr none(new Cloud);
              none->push_back({nan, nan, nan});
              c.setInputCloud(none);
            }),
            "no point of the cloud is finite");
  expectHas(message([](Check& c) { c.setIndices(pcl::IndicesPtr(new pcl::Indices{100000})); }), "index 100000");
  expectHas(message([](Check& c) { c.setCutter(CutterShape()); }), "radius");
  expectHas(message([](Check& c) { c.setTolerance(0.0); }), "tolerance is 0");
  expectHas(message([](Check& c) { c.setHolder({ToolSegment::cylinder(-1.0, 5.0, "shank")}); }), "shank");
  expectHas(message([](Check& c) { c.setHolderClearance(-2.0); }), "clearance is -2");
  expectHas(message([](Check& c) { c.setNumberOfThreads(-1); }), "threads is 4294967295");
  expectHas(message([](Check& c) { c.setProgressCallback([](double, const std::string&) { return false; }); }), "cancelled");
  Check check;
  check.setInputCloud(floorAndWall(9.0f));
  check.setCutter(CutterShape::ball(3.0));
  MachineProgram nothing;
  nothing.machine = testMachines().front();
  check.compute(nothing);
  expectHas(check.getStatus().message(), "no moves");
}

} // namespace lead_check_test
