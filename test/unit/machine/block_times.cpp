// SPDX-License-Identifier: BSD-3-Clause
// The time of each block: speeds of contact, tip, ball centre and axes on random ways, measured with the kinematics of the oracle.
#include "machine/block_times.h"

#include "support/machine_way.h"
#include "support/random_vectors.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace block_times_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double degrees = 180.0 / M_PI;

/** Machine coordinates of the oracle for a tip and angles: its tip is the program's place, turned and moved. */
Eigen::Vector3d
machineAt(const MachineChain& chain, const Eigen::Vector3d& tip, double first, double second)
{
  const auto tipAt = [&](const Eigen::Vector3d& xyz) { return forward(chain, {xyz, first * degrees, second * degrees}).tip; };
  const Eigen::Vector3d origin = tipAt(Eigen::Vector3d::Zero());
  Eigen::Matrix3d turn;
  for (int i = 0; i < 3; ++i)
    turn.col(i) = tipAt(Eigen::Vector3d::Unit(i)) - origin;
  return turn.transpose() * (tip - origin);
}

ProgramBlock
blockAt(const Machine& machine, const Eigen::Vector3d& tip, double first, double second, double arc_length, BlockSection section)
{
  const MachineChain chain = chainOf(machine);
  ProgramBlock block;
  block.section = section;
  block.tip = tip;
  block.angles = {first, second};
  block.machine = machineAt(chain, tip, first, second);
  block.axis = forward(chain, {block.machine, first * degrees, second * degrees}).axis;
  block.arc_length = arc_length;
  return block;
}

/** A way whose contact, tip and axes take steps of lengths that have nothing to do with each other; some of them stand. */
std::vector<ProgramBlock>
randomWay(const Machine& machine, Random& random)
{
  const auto step = [&](double largest) {
    return random.uniform(0.0, 1.0) < 0.15 ? 0.0 : largest * std::pow(10.0, random.uniform(-4.0, 0.0));
  };
  Eigen::Vector3d tip(20.0, -30.0, 15.0);
  double first = 0.3, second = 0.6, arc_length = 0.0;
  std::vector<ProgramBlock> way{blockAt(machine, tip, first, second, arc_length, BlockSection::Cut)};
  while (way.size() < 400) {
    tip += step(4.0) * randomUnit(random);
    first += step(0.8) * (random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
    second = std::clamp(second + step(0.3) * random.uniform(-1.0, 1.0), 0.2, 1.2);
    arc_length += step(4.0);
    if (tip == way.back().tip && first == way.back().angles.first && second == way.back().angles.second)
      continue; // programs have no blocks in which nothing moves
    way.push_back(blockAt(machine, tip, first, second, arc_length, BlockSection::Cut));
  }
  return way;
}

/** The largest speed of an axis in the block, as a share of its limit. */
double
axisShare(const Machine& machine, const ProgramBlock& a, const ProgramBlock& b)
{
  constexpr int steps = 100;
  const MachineChain chain = chainOf(machine);
  const auto mix = [](auto from, auto to, double t) { return from + t * (to - from); };
  const auto at = [&](double t) {
    return machine.rtcp ? machineAt(chain, a.tip + t * (b.tip - a.tip), mix(a.angles.first, b.angles.first, t),
                                    mix(a.angles.second, b.angles.second, t))
                        : Eigen::Vector3d(a.machine + t * (b.machine - a.machine));
  };
  double share = std::max(std::abs(b.angles.first - a.angles.first) / machine.rotary[0].range.largest_rate,
                          std::abs(b.angles.second - a.angles.second) / machine.rotary[1].range.largest_rate);
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps, reach = 1e-3;
    const Eigen::Vector3d speed = (at(t + reach) - at(t - reach)) / (2.0 * reach);
    for (int i = 0; i < 3; ++i)
      share = std::max(share, std::abs(speed[i]) / machine.linear[i].largest_rate);
  }
  return share / b.minutes;
}

MachineProgram
timed(const Machine& machine, const ProgramSettings& settings, const std::vector<ProgramBlock>& blocks)
{
  MachineProgram program;
  program.blocks = blocks;
  setBlockTimes(Kinematics(machine), settings, program);
  return program;
}

/** How often each bound sets the time of a block. */
struct Bounds {
  std::size_t contact = 0, fast_tool = 0, slow_tool = 0, still_contact = 0, axis = 0;
};

/** Checks that nothing in the block is too fast, and that it is as fast as can be: one of the bounds is reached. */
void
expectFastest(const Machine& machine, double feed, double ball, const ProgramBlock& a, const ProgramBlock& b, Bounds& bounds)
{
  const auto equal = [](double value, double limit) { return std::abs(value / limit - 1.0) < 1e-9; };
  const double tip = (b.tip - a.tip).norm(), centre = (b.tip + ball * b.axis - a.tip - ball * a.axis).norm();
  const double tool = std::max(tip, centre) / b.minutes, contact = (b.arc_length - a.arc_length) / b.minutes;
  const double axis = axisShare(machine, a, b);
  ASSERT_GT(b.minutes, 0.0);
  ASSERT_LE(tool, 2.0 * feed * (1.0 + 1e-9));
  ASSERT_LE(axis, 1.001);
  if (tool > 0.5 * feed * (1.0 + 1e-9)) {
    ASSERT_LE(contact, feed * (1.0 + 1e-9)) << "the contact is faster than the feed, and no jump";
  }
  if (axis > 0.999)
    ++bounds.axis;
  else if (contact == 0.0 && equal(tool, feed))
    ++bounds.still_contact;
  else if (equal(contact, feed))
    ++bounds.contact;
  else if (equal(tool, 2.0 * feed) && contact < feed)
    ++bounds.fast_tool;
  else if (equal(tool, 0.5 * feed) && contact > feed)
    ++bounds.slow_tool;
  else
    FAIL() << "slower than needed: contact " << contact << ", tool " << tool << " mm/min, axis at " << axis << " of its limit";
}

} // namespace

TEST(BlockTimes, NothingIsTooFastAndNothingSlowerThanNeeded)
{
  Random random(11);
  Bounds bounds;
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false})
      for (const double ball : {0.0, 6.0}) {
        machine.rtcp = rtcp;
        machine.linear[0].largest_rate = 9000.0;
        machine.linear[1].largest_rate = 6000.0;
        machine.linear[2].largest_rate = 5000.0;
        machine.rotary[0].range.largest_rate = 30.0 * 2.0 * M_PI;
        machine.rotary[1].range.largest_rate = 20.0 * 2.0 * M_PI;
        ProgramSettings settings;
        settings.feed = 800.0;
        settings.ball_radius = ball;
        const MachineProgram program = timed(machine, settings, randomWay(machine, random));
        std::size_t slowed = 0;
        double minutes = 0.0;
        for (std::size_t i = 1; i < program.blocks.size(); ++i) {
          const ProgramBlock &a = program.blocks[i - 1], &b = program.blocks[i];
          ASSERT_NO_FATAL_FAILURE(expectFastest(machine, settings.feed, ball, a, b, bounds)) << machine.name << ", block " << i;
          const double contact = b.arc_length - a.arc_length;
          slowed += contact > 0.0 && contact / b.minutes < settings.feed * (1.0 - 1e-9);
          slowed += contact == 0.0 && axisShare(machine, a, b) > 0.999;
          minutes += b.minutes;
        }
        EXPECT_NEAR(program.report.minutes, minutes, 1e-9 * minutes);
        EXPECT_NEAR(static_cast<double>(program.report.slowed_blocks), static_cast<double>(slowed), 2.0);
        EXPECT_GT(program.report.tool_slowed_blocks, 20U);
        EXPECT_GT(program.report.slowed_blocks, program.report.tool_slowed_blocks + 20U);
      }
  for (const std::size_t count : {bounds.contact, bounds.fast_tool, bounds.slow_tool, bounds.still_contact, bounds.axis})
    EXPECT_GT(count, 200U);
}

TEST(BlockTimes, ALongWayOfTheTipWithAShortOneOfTheContactRunsAtTwiceTheFeed)
{
  const Machine machine = testMachines()[0]; // no limits but those of the rotary axes
  const std::vector<ProgramBlock> way{blockAt(machine, {0, 0, 0}, 0.0, 0.5, 0.0, BlockSection::Cut),
                                      blockAt(machine, {1, 0, 0}, 0.0, 0.5, 0.001, BlockSection::Cut)};
  const MachineProgram program = timed(machine, ProgramSettings(), way);
  EXPECT_NEAR(1.0 / program.blocks[1].minutes, 2000.0, 1e-6) << "at the feed of the contact it would be 1 000 000 mm/min";
  EXPECT_EQ(program.report.slowed_blocks, 1U);
  EXPECT_EQ(program.report.tool_slowed_blocks, 1U);
}

TEST(BlockTimes, AJumpOfTheContactDoesNotStopTheTool)
{
  const Machine machine = testMachines()[0];
  const std::vector<ProgramBlock> way{blockAt(machine, {0, 0, 0}, 0.0, 0.5, 0.0, BlockSection::Cut),
                                      blockAt(machine, {0.1, 0, 0}, 0.0, 0.5, 14.0, BlockSection::Cut)};
  const MachineProgram program = timed(machine, ProgramSettings(), way);
  EXPECT_NEAR(0.1 / program.blocks[1].minutes, 500.0, 1e-6) << "at the feed of the contact it would be 7 mm/min";
  EXPECT_EQ(program.report.slowed_blocks, 0U);
}

TEST(BlockTimes, EachSectionHasItsFeed)
{
  const Machine machine = testMachines()[0];
  ProgramSettings settings;
  const auto speeds = [&] {
    std::vector<ProgramBlock> way{blockAt(machine, {0, 0, 0}, 0.0, 0.5, 0.0, BlockSection::Position)};
    way.front().rapid = true;
    for (const BlockSection section : {BlockSection::Approach, BlockSection::LeadIn, BlockSection::Cut, BlockSection::Link,
                                       BlockSection::LeadOut, BlockSection::Retract})
      way.push_back(blockAt(machine, way.back().tip + Eigen::Vector3d(0, 3, 4), 0.0, 0.5, 0.0, section));
    std::vector<double> found;
    const MachineProgram program = timed(machine, settings, way);
    for (std::size_t i = 1; i < way.size(); ++i)
      found.push_back(5.0 / program.blocks[i].minutes);
    return found;
  };
  const auto expect = [&](const std::vector<double>& wanted) {
    const std::vector<double> found = speeds();
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_NEAR(found[i], wanted[i], 1e-6) << "block " << i;
  };
  settings.feed = 1200.0;
  expect({1200, 1200, 1200, 1200, 1200, 1200});
  settings.plunge_feed = 300.0;
  settings.lead_feed = 700.0;
  settings.link_feed = 2400.0;
  expect({300, 700, 1200, 2400, 700, 700});
}

TEST(BlockTimes, FeedsOutOfRangeAreRefused)
{
  const auto refusal = [](const ProgramSettings& settings) {
    MachineProgramGenerator generator;
    generator.setMachine(testMachines()[0]);
    generator.setInputPoses({ToolPose(), ToolPose()});
    generator.setSettings(settings);
    MachineProgram program;
    generator.compute(program);
    EXPECT_FALSE(generator.getStatus().ok());
    return generator.getStatus().message();
  };
  ProgramSettings settings;
  settings.plunge_feed = -1.0;
  EXPECT_NE(refusal(settings).find("the plunge feed is -1 mm/min: it must be above 0 mm/min, or 0 for the feed"), std::string::npos);
  settings = {};
  settings.lead_feed = std::nan("");
  EXPECT_NE(refusal(settings).find("the lead feed is nan"), std::string::npos);
  settings = {};
  settings.link_feed = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(settings).find("the link feed is inf"), std::string::npos);
}

} // namespace block_times_test
