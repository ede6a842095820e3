// SPDX-License-Identifier: BSD-3-Clause
// The tool of a program at any time against the chain of matrices; times and lengths.
#include "machine/motion_track.h"
#include "machine/axis_extremes.h"
#include "machine/machine_bodies.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/machine_reader.h>

#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace motion_track_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

MachineProgram
randomProgram(const Machine& machine, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Kinematics kinematics(machine);
  MachineProgram program;
  program.machine = machine;
  Eigen::Vector3d tip(10.0, -5.0, 3.0);
  for (int i = 0; i < 200; ++i) {
    ProgramBlock block;
    tip += i % 17 == 3 ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(share(random), share(random), 0.2 * share(random));
    block.tip = tip;
    block.angles = {3.0 * share(random), 0.6 * share(random)};
    block.axis = block.normal = kinematics.toolAxis(block.angles);
    block.machine = kinematics.programmed(tip, block.angles);
    block.rapid = i % 23 == 5;
    block.minutes = block.rapid ? 0.0 : 1e-3 * (1.5 + share(random));
    program.blocks.push_back(block);
  }
  return program;
}

/** The tool at share \p t of block \p b, by the oracle: linear axes of the tip with RTCP, of the machine without. */
TipAndAxis
toolIn(const MachineProgram& program, std::size_t b, double t)
{
  const ProgramBlock &from = program.blocks[b > 0 ? b - 1 : 0], &to = program.blocks[b];
  const double first = (1.0 - t) * from.angles.first + t * to.angles.first, second = (1.0 - t) * from.angles.second + t * to.angles.second;
  TipAndAxis at =
      forward(chainOf(program.machine), {from.machine + t * (to.machine - from.machine), first * in_degrees, second * in_degrees});
  if (program.machine.rtcp)
    at.tip = from.tip + t * (to.tip - from.tip);
  return at;
}

/** Those of the examples, and the machines of the tests. */
std::vector<Machine>
allMachines()
{
  std::vector<Machine> machines = testMachines();
  for (const char* name : {"head_head", "head_table", "three_axes", "xyzac", "xyzbc"})
    machines.push_back(readMachine(std::string(PCL_SPIRAL_MACHINES_DIR) + "/" + name + ".yaml"));
  return machines;
}

/** What must stand still stands: a spindle that no head axis turns, a part that no table axis turns. */
void
expectStill(const Machine& machine, const MachineStand& stand)
{
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  const auto turns = [&](RotaryMount mount) {
    return !machine.three_axes && (machine.rotary[0].mount == mount || machine.rotary[1].mount == mount);
  };
  EXPECT_TRUE(stand.of(MachineBody::Ground).isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(stand.of(MachineBody::Slide).linear().isApprox(none));
  if (!turns(RotaryMount::Head))
    EXPECT_TRUE(stand.tool().linear().isApprox(none)) << machine.name;
  if (!turns(RotaryMount::Table))
    EXPECT_TRUE(stand.part().isApprox(Eigen::Isometry3d::Identity())) << machine.name;
}

} // namespace

TEST(MotionTrack, TheBodiesOfTheMachineHoldToolAndPartAsThePathAsks)
{
  for (const Machine& machine : allMachines()) {
    const MachineProgram program = randomProgram(machine, 23);
    const MotionTime time = *motionTime(program, controlModel(ControlKind::LinuxCNC));
    const MotionTrack track(program, time);
    for (int i = 0; i <= 1000; ++i) {
      const MotionFrame frame = track.at(time.seconds * i / 1000.0);
      const MachineStand stand(track.kinematics(), frame.tip, frame.angles);
      const Eigen::Isometry3d tool = stand.part().inverse() * stand.tool();
      ASSERT_LT((tool.translation() - frame.tip).norm(), 1e-6) << machine.name << ' ' << i;
      ASSERT_LT((tool.linear().col(2) - frame.axis).norm(), 1e-6) << machine.name << ' ' << i;
      const Eigen::Vector3d axes = stand.of(MachineBody::Slide).translation() - Eigen::Vector3d(0.0, 0.0, machine.tool_length);
      const TipAndAxis by_chain = forward(chainOf(machine), {axes, frame.angles.first * in_degrees, frame.angles.second * in_degrees});
      ASSERT_LT((tool.translation() - by_chain.tip).norm(), 1e-6) << machine.name << ' ' << i;
      ASSERT_LT((tool.linear().col(2) - by_chain.axis).norm(), 1e-6) << machine.name << ' ' << i;
      expectStill(machine, stand);
    }
  }
}

TEST(MotionTrack, OnArcsOfTheAxisTheRotaryAxesFollowIt)
{
  for (const char* name : {"xyzac", "head_head"}) {
    const MachineProgram program = randomProgram(readMachine(std::string(PCL_SPIRAL_MACHINES_DIR) + "/" + name + ".yaml"), 5);
    const MotionTime time = *motionTime(program, controlModel(ControlKind::Siemens));
    const MotionTrack track(program, time, true);
    for (int i = 0; i <= 1000; ++i) {
      const MotionFrame frame = track.at(time.seconds * i / 1000.0);
      ASSERT_LT((track.kinematics().toolAxis(frame.angles) - frame.axis).norm(), 1e-6) << name << ' ' << i;
    }
  }
}

TEST(MotionTrack, TheTableHoldsThePartAndTheSpindleTheTool)
{
  const Eigen::AlignedBox3d part(Eigen::Vector3d(-40, -30, -5), Eigen::Vector3d(60, 30, 25));
  for (const Machine& machine : allMachines()) {
    const double tool_height = 90.0, tip_to_gauge = machine.tool_length;
    std::size_t under = 0, above = 0;
    for (const MachineSolid& solid : machineSolids(machine, part, tool_height)) {
      ASSERT_TRUE(solid.a.allFinite() && solid.b.allFinite()) << machine.name;
      under += solid.body == MachineBody::Table && std::max(solid.a.z(), solid.b.z()) < part.min().z();
      above += solid.body == MachineBody::Spindle && std::min(solid.a.z(), solid.b.z()) >= tool_height - tip_to_gauge - 1e-9;
    }
    EXPECT_GE(under, 1U) << machine.name;
    EXPECT_GE(above, 2U) << machine.name;
  }
}

TEST(MotionTrack, TheEndsOfTheWayOfEachAxisAreFound)
{
  for (const Machine& machine : allMachines()) {
    const MachineProgram program = randomProgram(machine, 31);
    const std::vector<AxisExtreme> extremes = axisExtremes(program);
    ASSERT_EQ(extremes.size(), machine.three_axes ? 6U : 10U) << machine.name;
    for (std::size_t k = 0; k < extremes.size(); ++k) {
      const std::size_t axis = k / 2;
      const auto valueOf = [&](const ProgramBlock& block) {
        const Eigen::Vector3d gauge = block.machine + machine.work_zero + Eigen::Vector3d(0.0, 0.0, machine.tool_length);
        return axis < 3 ? gauge[static_cast<Eigen::Index>(axis)] : axis == 3 ? block.angles.first : block.angles.second;
      };
      const AxisRange& range = axis < 3 ? machine.linear[axis] : machine.rotary[axis - 3].range;
      EXPECT_EQ(extremes[k].limit, extremes[k].largest ? range.upper : range.lower);
      EXPECT_EQ(extremes[k].rotary, axis >= 3);
      EXPECT_NEAR(extremes[k].value, valueOf(program.blocks[extremes[k].block]), 1e-9);
      for (const ProgramBlock& block : program.blocks)
        ASSERT_LE(extremes[k].largest ? valueOf(block) : -valueOf(block), (extremes[k].largest ? 1.0 : -1.0) * extremes[k].value + 1e-9);
    }
  }
}

TEST(MotionTrack, EveryPlaceIsThatOfTheForwardKinematics)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      machine.rtcp = rtcp;
      const MachineProgram program = randomProgram(machine, 11);
      const MotionTime time = *motionTime(program, controlModel(ControlKind::LinuxCNC));
      const MotionTrack track(program, time);
      EXPECT_NEAR(track.seconds(), time.seconds, 1e-9);
      double begin = 0.0;
      for (std::size_t b = 1; b < program.blocks.size(); ++b) {
        EXPECT_NEAR(track.endOf(b) - begin, time.blocks[b], 1e-9);
        for (const double t : {share(random), share(random), 1.0 - 1e-9}) {
          const MotionFrame frame = track.at(begin + t * time.blocks[b]);
          ASSERT_EQ(frame.block, b);
          const TipAndAxis tool = toolIn(program, b, frame.share);
          ASSERT_LT((frame.tip - tool.tip).norm(), 1e-6) << machine.name << ' ' << b;
          ASSERT_LT((frame.axis - tool.axis).norm(), 1e-6) << machine.name << ' ' << b;
          ASSERT_NEAR(frame.share, t, 1e-6);
        }
        begin = track.endOf(b);
      }
    }
}

TEST(MotionTrack, TimeAndLengthGoOneWay)
{
  const MachineProgram program = randomProgram(testMachines().front(), 3);
  const MotionTrack track(program, *motionTime(program, controlModel(ControlKind::Fanuc)));
  double way = 0.0, seconds = 0.0;
  for (std::size_t b = 1; b < program.blocks.size(); ++b) {
    way += (program.blocks[b].tip - program.blocks[b - 1].tip).norm();
    EXPECT_GE(track.endOf(b), track.endOf(b - 1));
  }
  EXPECT_NEAR(track.length(), way, 1e-9);
  for (int i = 0; i <= 1000; ++i) {
    const double at = way * i / 1000.0, found = track.secondsAt(at);
    EXPECT_GE(found, seconds);
    EXPECT_NEAR(track.at(found).length, at, 1e-6);
    seconds = found;
  }
  EXPECT_LT((track.at(-1.0).tip - program.blocks.front().tip).norm(), 1e-12);
  EXPECT_LT((track.at(2.0 * track.seconds()).tip - program.blocks.back().tip).norm(), 1e-12);
  EXPECT_EQ(track.at(2.0 * track.seconds()).block + 1, program.blocks.size());
}

TEST(MotionTrack, FeedStandsBesideWhatTheBlockAsksFor)
{
  MachineProgram program;
  program.machine = xyzacTrunnion();
  program.blocks.resize(3);
  program.blocks[1].tip.x() = program.blocks[1].machine.x() = program.blocks[2].tip.x() = program.blocks[2].machine.x() = 50.0;
  program.blocks[2].tip.y() = program.blocks[2].machine.y() = 50.0;
  program.blocks[1].minutes = 50.0 / 3000.0;
  program.blocks[2].rapid = true;
  const MotionTrack track(program, *motionTime(program, controlModel(ControlKind::ExactStop)));
  const MotionFrame cut = track.at(0.5 * track.endOf(1)), rapid = track.at(track.endOf(1) + 1e-3);
  EXPECT_NEAR(cut.asked, 3000.0, 1e-9);
  EXPECT_NEAR(cut.feed, 60.0 * 50.0 / (50.0 / 50.0 + 50.0 / 2000.0), 1e-6) << "a trapezoid at 2000 mm/s2";
  EXPECT_EQ(rapid.asked, 0.0);
  EXPECT_GT(rapid.feed, 3000.0);
}

} // namespace motion_track_test
