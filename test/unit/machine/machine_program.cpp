// SPDX-License-Identifier: BSD-3-Clause
// Programs of every kind of machine: unwinding, pole, finite axes, limits, spacing of blocks, times and
// leads.
#include <pcl_spiral/machine/machine_program_generator.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/machine_way.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace machine_program_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double degrees = 180.0 / M_PI;

ProgramSettings
ballSettings(double ball)
{
  ProgramSettings settings;
  settings.ball_radius = ball;
  return settings;
}

MachineProgram
made(const Machine& machine, const ToolPoses& poses, const ProgramSettings& settings)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(poses);
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

std::string
refusal(const Machine& machine, const ToolPoses& poses, const ProgramSettings& settings = {})
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(poses);
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_FALSE(generator.getStatus().ok());
  EXPECT_TRUE(program.blocks.empty());
  return generator.getStatus().message();
}

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

/** Largest distance of the machine from the poses, as a share of the tolerances: over dense samples of the path
 * in order, the least over the machine's motion in the next \p ahead blocks. */
double
leaving(const Machine& machine, const MachineProgram& program, const ToolPoses& poses, double tip, double axis, std::size_t ahead)
{
  std::vector<ProgramBlock> way;
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    if (program.blocks[i].section == BlockSection::Cut) {
      if (way.empty())
        way.push_back(program.blocks[i - 1]);
      way.push_back(program.blocks[i]);
    }
  double largest = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i)
    for (double s : {0.0, 0.3, 0.5, 0.8}) {
      const ToolPose pose = between(poses[i], poses[i + 1], s);
      double least = 1e9;
      std::size_t best = at;
      for (std::size_t k = at; k + 1 < way.size() && k < at + ahead; ++k)
        for (double centre = 0.5, reach = 0.5; reach > 1e-4; reach *= 0.1) { // in finer steps round the nearest
          const double begin = std::max(0.0, centre - reach), end = std::min(1.0, centre + reach);
          for (int j = 0; j <= 20; ++j) {
            const double t = begin + (end - begin) * j / 20.0;
            const TipAndAxis found = onTheWay(machine, way[k], way[k + 1], t);
            const double off = std::max((found.tip - pose.tip).norm() / tip, angleBetween(found.axis, pose.axis) / axis);
            if (off < least) {
              least = off;
              best = k;
              centre = t;
            }
          }
        }
      at = best;
      largest = std::max(largest, least);
    }
  return largest;
}

/** A straight pass over a dome through its pole, axis along the normal. */
ToolPoses
passOverThePole(double sphere, double offset)
{
  ToolPoses poses;
  for (int i = -100; i <= 100; ++i) {
    ToolPose pose;
    const double u = i * 0.5 / sphere, v = offset / sphere;
    pose.normal = Eigen::Vector3d(std::sin(u), std::sin(v), std::sqrt(1.0 - std::pow(std::sin(u), 2) - std::pow(std::sin(v), 2)));
    pose.axis = pose.normal;
    pose.contact = sphere * pose.normal;
    pose.tip = pose.contact;
    poses.push_back(pose);
  }
  return poses;
}

} // namespace

TEST(MachineProgram, TurnsAreCountedOnAndBlocksStayBelowAHalfTurn)
{
  for (const Machine& machine : testMachines()) {
    const MachineProgram program = made(machine, domeSpiral(300.0, 2.0, 30, 40, 6.0, 12.0), ballSettings(6.0));
    const ProgramReport& report = program.report;
    EXPECT_GT(report.highest_first - report.lowest_first, 28.0 * 2.0 * M_PI) << machine.name;
    EXPECT_GT(report.first_travel, 28.0 * 2.0 * M_PI);
    for (std::size_t i = 1; i < program.blocks.size(); ++i) {
      const RotaryAngles &a = program.blocks[i - 1].angles, &b = program.blocks[i].angles;
      ASSERT_LT(std::max(std::abs(b.first - a.first), std::abs(b.second - a.second)), M_PI);
    }
    EXPECT_TRUE(report.unwound_at.empty());
    EXPECT_LE(std::abs(program.blocks.front().angles.first), M_PI + 1e-9) << "as near to home as can be";
  }
}

TEST(MachineProgram, OfTwoBranchesTheOneWithinTheLimitsIsTaken)
{
  Machine machine = testMachines()[0];
  const ToolPoses poses = domeSpiral(300.0, 2.0, 30, 40, 6.0, 12.0);
  EXPECT_EQ(made(machine, poses, ballSettings(6.0)).report.branch, Branch::Larger);
  machine.rotary[1].range.lower = -100.0 / degrees;
  machine.rotary[1].range.upper = 10.0 / degrees;
  const MachineProgram program = made(machine, poses, ballSettings(6.0));
  EXPECT_EQ(program.report.branch, Branch::Smaller);
  EXPECT_LT(program.report.highest_second, 1e-9);
  machine.rotary[1].range.lower = -10.0 / degrees;
  const std::string message = refusal(machine, poses, ballSettings(6.0));
  for (const char* part : {"block ", " mm of the path: A would be at ", " degrees above its upper limit of 10 degrees", "turn the part"})
    expectHas(message, part);
}

TEST(MachineProgram, NoAxisIsAskedForMoreThanItsRateAndTheFeedIsTheContacts)
{
  for (Machine machine : testMachines()) {
    machine.linear[0].largest_rate = machine.linear[1].largest_rate = machine.linear[2].largest_rate = 5000.0;
    machine.rtcp = false;
    machine.rotary[0].range.largest_rate = 15.0 * 2.0 * M_PI;
    ProgramSettings settings = ballSettings(6.0);
    settings.feed = 1500.0;
    const MachineProgram program = made(machine, domeSpiral(100.0, 2.0, 30, 90, 6.0, 12.0), settings);
    double minutes = 0.0;
    std::size_t at_feed = 0, slower = 0;
    for (std::size_t i = 1; i < program.blocks.size(); ++i) {
      const ProgramBlock &a = program.blocks[i - 1], &b = program.blocks[i];
      if (b.rapid)
        continue;
      ASSERT_GT(b.minutes, 0.0);
      minutes += b.minutes;
      const double least = b.minutes * (1.0 + 1e-9);
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_LE(std::abs(b.machine[axis] - a.machine[axis]) / machine.linear[axis].largest_rate, least);
      ASSERT_LE(std::abs(b.angles.first - a.angles.first) / machine.rotary[0].range.largest_rate, least);
      ASSERT_LE(std::abs(b.angles.second - a.angles.second) / machine.rotary[1].range.largest_rate, least);
      if (b.section != BlockSection::Cut)
        continue;
      const double feed = (b.arc_length - a.arc_length) / b.minutes;
      ASSERT_LE(feed, 1500.0 * (1.0 + 1e-9));
      (feed > 1499.999 ? at_feed : slower)++;
    }
    EXPECT_NEAR(minutes, program.report.minutes, 1e-9);
    EXPECT_EQ(slower, program.report.slowed_blocks);
    EXPECT_GT(slower, 10U) << "rho_min is 16 mm";
    EXPECT_GT(at_feed, 1000U);
    EXPECT_LT(program.report.least_feed_share, 1.0);
  }
}

TEST(MachineProgram, NearThePoleTheAxisIsBlendedAndTheBallStays)
{
  for (double offset : {0.0, 0.2, 1.0})
    for (const Machine& machine : testMachines()) {
      const double ball = 5.0;
      ToolPoses poses = passOverThePole(200.0, offset);
      ProgramSettings settings = ballSettings(ball);
      settings.feed = 1000.0;
      const MachineProgram program = made(machine, poses, settings);
      const double rho_min = settings.feed / machine.rotary[0].range.largest_rate; // radius of a turn round the pole
      ASSERT_EQ(program.report.poles.size(), 1U) << machine.name << offset;
      const PoleZone& zone = program.report.poles[0];
      EXPECT_NEAR(0.5 * (zone.begin + zone.end), 50.0, 1.1);
      EXPECT_LT(zone.end - zone.begin, 4.0 * rho_min + 1.1);
      EXPECT_LT(zone.largest_change, 2.0 * (rho_min + 1.0) / 200.0 + 1e-3) << "twice the pole angle at the zone's end";
      std::size_t i = 0;
      for (const ProgramBlock& block : program.blocks) { // ball centres run on a straight line in order
        if (block.section != BlockSection::Cut)
          continue;
        const Eigen::Vector3d centre = block.tip + ball * block.axis;
        double least = 1e9;
        for (std::size_t k = i; k + 1 < poses.size() && k < i + 3; ++k) {
          const Eigen::Vector3d a = poses[k].tip + ball * poses[k].axis, b = poses[k + 1].tip + ball * poses[k + 1].axis;
          const double t = std::clamp((centre - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
          const double off = (a + t * (b - a) - centre).norm();
          if (off < least) {
            least = off;
            i = k;
          }
        }
        ASSERT_LT(least, 0.003) << machine.name;
      }
    }
}

TEST(MachineProgram, FarFromThePoleNothingIsBlended)
{
  ToolPoses poses = passOverThePole(200.0, 40.0);
  const MachineProgram program = made(testMachines()[0], poses, ballSettings(5.0));
  EXPECT_TRUE(program.report.poles.empty());
  EXPECT_EQ(program.report.slowed_blocks, 0U);
}

TEST(MachineProgram, AFiniteAxisRetractsUnwindsAndComesBackWhereItLeft)
{
  for (Machine machine : testMachines()) {
    machine.rotary[0].range.lower = -400.0 / degrees;
    machine.rotary[0].range.upper = 500.0 / degrees;
    for (const bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const ToolPoses poses = domeSpiral(300.0, 2.0, 12, 60, 6.0, 12.0);
      const MachineProgram program = made(machine, poses, ballSettings(6.0));
      EXPECT_GE(program.report.unwound_at.size(), 4U) << "near 11 turns, two and a half at the most each";
      EXPECT_LE(program.report.unwound_at.size(), 7U);
      double highest = -1e9;
      for (const ToolPose& pose : poses)
        highest = std::max(highest, pose.tip.z());
      const ProgramBlock* left = nullptr;
      std::size_t back = 0;
      for (std::size_t i = 1; i < program.blocks.size(); ++i) {
        const ProgramBlock &before = program.blocks[i - 1], &block = program.blocks[i];
        ASSERT_GE(block.angles.first, machine.rotary[0].range.lower - 1e-9);
        ASSERT_LE(block.angles.first, machine.rotary[0].range.upper + 1e-9);
        ASSERT_LT(std::abs(block.angles.first - before.angles.first), M_PI);
        if (block.section == BlockSection::LeadOut)
          left = &before;
        if (left != nullptr && before.section == BlockSection::LeadIn && block.section == BlockSection::Cut) {
          ++back;
          EXPECT_LT((before.tip - left->tip).norm(), 1e-9);
          EXPECT_LT(angleBetween(before.axis, left->axis), 1e-9);
        }
        if (block.section == BlockSection::Unwind)
          for (double t : {0.0, 0.5, 1.0})
            ASSERT_GT(onTheWay(machine, before, block, t).tip.z(), highest + 10.0) << machine.name << rtcp;
      }
      EXPECT_EQ(back, program.report.unwound_at.size());
    }
  }
}

TEST(MachineProgram, AnAxisThatCannotComeRoundIsRefused)
{
  Machine machine = testMachines()[0];
  machine.rotary[0].range.lower = -80.0 / degrees;
  machine.rotary[0].range.upper = 80.0 / degrees;
  const std::string message = refusal(machine, domeSpiral(300.0, 2.0, 12, 60, 6.0, 12.0), ballSettings(6.0));
  for (const char* part : {" mm of the path C is at ", "limits of -80 to 80 degrees", "turn the part"})
    expectHas(message, part);
}

TEST(MachineProgram, LimitsOfLinearAxesAreCheckedInMachineCoordinates)
{
  Machine machine = testMachines()[0];
  const ToolPoses poses = domeSpiral(300.0, 2.0, 12, 60, 6.0, 12.0);
  const MachineProgram program = made(machine, poses, ballSettings(6.0));
  double lowest = 1e9;
  for (const ProgramBlock& block : program.blocks) { // the gauge point of the spindle, by the chain of the oracle
    const AxisValues values{block.machine, block.angles.first * degrees, block.angles.second * degrees};
    ASSERT_LT((forward(chainOf(machine), values).tip - block.tip).norm(), 1e-9);
    lowest = std::min(lowest, block.machine.z() + machine.work_zero.z() + machine.tool_length);
  }
  machine.linear[2].lower = lowest - 0.01;
  EXPECT_FALSE(made(machine, poses, ballSettings(6.0)).blocks.empty());
  machine.linear[2].lower = lowest + 0.01;
  const std::string message = refusal(machine, poses, ballSettings(6.0));
  for (const char* part : {"block ", ": Z would be at ", " mm below its lower limit of ", "work_zero"})
    expectHas(message, part);
}

TEST(MachineProgram, BlocksAreSplitUntilTheMachineStaysNear)
{
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const ToolPoses all = domeSpiral(150.0, 4.0, 6, 24, 6.0, 12.0);
      const ToolPoses poses(all.begin() + 48, all.end()); // away from the pole
      ProgramSettings settings = ballSettings(6.0);
      settings.block = {0.01, 0.002};
      const MachineProgram program = made(machine, poses, settings);
      EXPECT_GT(program.report.split_blocks, rtcp ? 0U : 200U);
      EXPECT_LT(leaving(machine, program, poses, settings.block.tip, settings.block.axis, 24), 1.05) << machine.name << rtcp;
    }
}

TEST(MachineProgram, ThinnedBlocksKeepTipAndAxisWithinTheTolerance)
{
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const ToolPoses all = domeSpiral(150.0, 4.0, 5, 540, 6.0, 12.0);
      const ToolPoses poses(all.begin() + 2160, all.end());
      ProgramSettings settings = ballSettings(6.0);
      settings.block = {0.002, 0.0005};
      settings.thinning = {0.02, 0.003};
      const MachineProgram program = made(machine, poses, settings);
      EXPECT_GT(program.report.thinned_poses, poses.size() * (rtcp ? 6 : 2) / 10) << machine.name << rtcp;
      EXPECT_LT(
          leaving(machine, program, poses, settings.thinning.tip + settings.block.tip, settings.thinning.axis + settings.block.axis, 3),
          1.05)
          << machine.name << rtcp;
    }
}

TEST(MachineProgram, LeadsComeFromAboveAndArcsAreTangent)
{
  for (const LeadKind lead : {LeadKind::Normal, LeadKind::Arc}) {
    ProgramSettings settings = ballSettings(6.0);
    settings.lead = lead;
    settings.lead_length = 3.0;
    const ToolPoses all = domeSpiral(150.0, 4.0, 6, 90, 6.0, 12.0);
    const ToolPoses poses(all.begin() + 270, all.end());
    const MachineProgram program = made(testMachines()[0], poses, settings);
    EXPECT_TRUE(program.blocks.front().rapid);
    EXPECT_EQ(program.blocks.front().section, BlockSection::Position);
    EXPECT_GE(program.blocks.front().tip.z(), poses.front().tip.z() + settings.rapid_height);
    EXPECT_TRUE(program.blocks.back().rapid);
    EXPECT_GE(program.blocks.back().tip.z(), poses.front().tip.z() + settings.rapid_height - 1e-9);
    const ProgramBlock *before = nullptr, *last = nullptr, *cut = nullptr;
    for (std::size_t i = 1; i < program.blocks.size(); ++i) {
      const ProgramBlock& block = program.blocks[i];
      if (block.section == BlockSection::LeadIn) {
        before = &program.blocks[i - 1];
        last = &block;
        // Above the surface along the whole lead: the ball's centre is at least its radius from the contact.
        const Eigen::Vector3d centre = block.tip + 6.0 * block.axis;
        EXPECT_GE((centre + Eigen::Vector3d(0, 0, 150.0)).norm(), 156.0 - 1e-3);
        EXPECT_FALSE(block.rapid);
      }
      if (cut == nullptr && block.section == BlockSection::Cut)
        cut = &block;
    }
    ASSERT_TRUE(last != nullptr && cut != nullptr);
    EXPECT_LT((last->tip - poses.front().tip).norm(), 1e-9);
    const Eigen::Vector3d in = (last->tip - before->tip).normalized(), on = (cut->tip - last->tip).normalized();
    EXPECT_GT(lead == LeadKind::Arc ? in.dot(on) : in.dot(-poses.front().normal), 0.998);
  }
}

TEST(MachineProgram, WhatCannotBeIsNamed)
{
  const Machine machine = testMachines()[0];
  ToolPoses poses = domeSpiral(150.0, 4.0, 1, 40, 6.0, 0.0);
  expectHas(refusal(machine, {}), "0 poses");
  ProgramSettings settings;
  settings.feed = 0.0;
  expectHas(refusal(machine, poses, settings), "feed is 0");
  settings = {};
  settings.clearance = -1.0;
  expectHas(refusal(machine, poses, settings), "clearance is -1");
  settings = {};
  settings.block.tip = 0.0;
  expectHas(refusal(machine, poses, settings), "block tolerance is 0");
  poses[3].axis = {0.0, 0.0, 2.0};
  expectHas(refusal(machine, poses), "pose 3");
  poses[3].axis = Eigen::Vector3d(0.0, 0.8, -0.6);
  expectHas(refusal(testMachines()[4], poses), "no angles of C and B reach the tool axis (0, 0.8, -0.6)");
}

} // namespace machine_program_test
