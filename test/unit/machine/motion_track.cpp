// SPDX-License-Identifier: BSD-3-Clause
// The tool of a program at any time against the chain of matrices; times and lengths.
#include "machine/motion_track.h"
#include <pcl_spiral/core/impl/angles.h>

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

} // namespace

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
