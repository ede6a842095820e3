// SPDX-License-Identifier: BSD-3-Clause
// Turns with a tiny linear part: none is written that LinuxCNC would run too fast, by its text and by its own interpreter.
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "core/angle_between.h"
#include "support/canonical_run.h"
#include "support/machine_way.h"
#include "support/program_parsers.h"
#include "support/random_vectors.h"
#include "support/scratch_folder.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiny_moves_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double least_rate = 0.1; ///< of LinuxCNC's interpreter, mm/min

/** A pass whose tip hardly moves in some places while its axis leans and goes round: the contact rolls over an edge. */
ToolPoses
rollingPass(std::uint64_t seed)
{
  Random random(seed);
  ToolPoses poses;
  double lean = 0.4, round = 0.0;
  ToolPose pose;
  for (int i = 0; i < 200; ++i) {
    const bool rolls = i % 20 < 14;
    if (rolls) {
      round += random.uniform(0.02, 0.3);
      lean = std::clamp(lean + random.uniform(-0.05, 0.05), 0.2, 0.9);
    }
    const double step = rolls ? std::pow(10.0, random.uniform(-6.0, -2.5)) : random.uniform(0.1, 1.0);
    pose.tip += step * randomUnit(random);
    pose.contact += (rolls ? 1e-3 : 1.0) * random.uniform(0.1, 1.0) * randomUnit(random);
    pose.axis = {std::sin(lean) * std::cos(round), std::sin(lean) * std::sin(round), std::cos(lean)};
    pose.normal = pose.axis;
    poses.push_back(pose);
  }
  return poses;
}

Machine
slowed(Machine machine, double turns_a_minute)
{
  for (RotaryAxis& axis : machine.rotary)
    axis.range.largest_rate = turns_a_minute * 2.0 * M_PI;
  return machine;
}

MachineProgram
made(const Machine& machine, const ToolPoses& poses)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(poses);
  ProgramSettings settings;
  settings.pole_cone = 0.0; // every pose is kept
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** The pose of the pass after \p length of its contacts. */
ToolPose
poseAt(const ToolPoses& poses, double length)
{
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double step = (poses[i].contact - poses[i - 1].contact).norm();
    if (length <= step + 1e-12)
      return between(poses[i - 1], poses[i], std::min(1.0, length / step));
    length -= step;
  }
  return poses.back();
}

/** Moves of the text in which a rotary axis turns while X Y Z go slower than LinuxCNC can. */
std::size_t
hurriedMoves(const ParsedProgram& parsed)
{
  std::size_t hurried = 0;
  for (std::size_t i = 1; i < parsed.moves.size(); ++i) {
    const ParsedMove &from = parsed.moves[i - 1], &to = parsed.moves[i];
    const double way = (to.xyz - from.xyz).norm();
    hurried += !to.rapid && way > 0.0 && from.degrees != to.degrees && way < least_rate * to.minutes;
  }
  return hurried;
}

double
minutesOf(const ProgramFile& read)
{
  double minutes = 0.0;
  for (const ProgramBlock& block : read.program.blocks)
    minutes += block.minutes;
  return minutes;
}

} // namespace

TEST(TinyMoves, NoTurnWithATinyLinearPartIsWritten)
{
  const ScratchFolder folder;
  std::size_t turns_alone = 0;
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false})
      for (const auto& [turns_a_minute, decimals] : {std::pair(0.5, 3), std::pair(5.0, 4), std::pair(30.0, 6)}) {
        machine = slowed(machine, turns_a_minute);
        machine.rtcp = rtcp;
        writeProgram(folder.path("a.ngc"), made(machine, rollingPass(5)), Dialect::LinuxCNC, {"rolls", 0.0, 0, decimals});
        const ParsedProgram parsed = parseFanuc(folder.path("a.ngc"));
        EXPECT_EQ(hurriedMoves(parsed), 0U) << machine.name << ", " << turns_a_minute << " rev/min, " << decimals << " decimals";
        for (std::size_t i = 1; i < parsed.moves.size(); ++i)
          turns_alone += parsed.moves[i].xyz == parsed.moves[i - 1].xyz && parsed.moves[i].degrees != parsed.moves[i - 1].degrees;
      }
  EXPECT_GT(turns_alone, 1000U) << "the tip was planted to rest";
}

TEST(TinyMoves, TheToolStaysWithinTheToleranceOfItsWay)
{
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      machine = slowed(machine, 2.0);
      machine.rtcp = rtcp;
      const ToolPoses poses = rollingPass(6);
      const MachineProgram program = made(machine, poses);
      const BlockTolerance tolerance;
      double tip = 0.0, axis = 0.0;
      for (std::size_t i = 1; i < program.blocks.size(); ++i) {
        const ProgramBlock &a = program.blocks[i - 1], &b = program.blocks[i];
        if (b.section != BlockSection::Cut)
          continue;
        for (double t : {0.25, 0.5, 0.75, 1.0}) {
          const TipAndAxis found = onTheWay(machine, a, b, t);
          const ToolPose wanted = poseAt(poses, a.arc_length + t * (b.arc_length - a.arc_length));
          tip = std::max(tip, (found.tip - wanted.tip).norm());
          axis = std::max(axis, angleBetween(found.axis, wanted.axis));
        }
      }
      EXPECT_LE(tip, tolerance.tip) << machine.name << rtcp;
      EXPECT_LE(axis, tolerance.axis * 1.01) << machine.name << rtcp;
      EXPECT_LT((program.blocks.back().tip - program.blocks.front().tip).norm(), 1e3);
    }
}

TEST(TinyMoves, LinuxCNCsInterpreterGivesEveryBlockItsTime)
{
  const ScratchFolder folder;
  const MachineProgram program = made(slowed(testMachines()[0], 5.0), rollingPass(7));
  writeProgram(folder.path("a.ngc"), program, Dialect::LinuxCNC, {"rolls", 0.0, 0, 4});
  const CanonicalRun run = interpret(folder.path("a.ngc"), folder);
  ASSERT_EQ(run.code, 0) << run.messages;
  std::vector<double> wanted;
  for (const ProgramBlock& block : program.blocks)
    if (!block.rapid)
      wanted.push_back(block.minutes);
  std::size_t at = 0;
  for (std::size_t i = 1; i < run.motions.size(); ++i) {
    if (run.motions[i].rapid)
      continue;
    ASSERT_LT(at, wanted.size());
    const double minutes = minutesOf(run.motions[i - 1], run.motions[i]);
    if (minutes > 0.0) {
      ASSERT_NEAR(minutes / wanted[at], 1.0, 1e-3) << "block " << at;
    }
    ++at;
  }
  EXPECT_EQ(at, wanted.size());
}

TEST(TinyMoves, HeidenhainsFeedIsThatOfTheTipOrOfTheTurnAndNeverAFloor)
{
  const ScratchFolder folder;
  std::size_t turns_alone = 0;
  for (const Machine& kind : testMachines()) {
    const Machine machine = slowed(kind, 5.0);
    const MachineProgram program = made(machine, rollingPass(9));
    writeProgram(folder.path("a.h"), program, Dialect::Heidenhain, {"rolls", 0.0, 0, 4});
    const ParsedProgram parsed = parseHeidenhain(folder.path("a.h"));
    ASSERT_EQ(parsed.moves.size(), program.blocks.size());
    for (std::size_t i = 1; i < parsed.moves.size(); ++i) {
      const ProgramBlock &a = program.blocks[i - 1], &b = program.blocks[i];
      if (b.rapid)
        continue;
      const double turn = std::hypot(b.angles.first - a.angles.first, b.angles.second - a.angles.second) * 180.0 / M_PI;
      const bool stands = parsed.moves[i].xyz == parsed.moves[i - 1].xyz;
      if (stands && turn == 0.0)
        continue; // less than the last decimal
      turns_alone += stands;
      ASSERT_GT(parsed.moves[i].feed, 0.05) << machine.name << ", block " << i;
      ASSERT_NEAR((stands ? turn / parsed.moves[i].feed : parsed.moves[i].minutes) / b.minutes, 1.0, 0.01)
          << machine.name << ", block " << i;
    }
    EXPECT_NEAR(minutesOf(readProgram(folder.path("a.h"), machine)) / program.report.minutes, 1.0, 0.01) << machine.name << ", read back";
    ProgramHeader header{"rolls", 0.0, 1, 4};
    header.feed_mode = FeedMode::PerMinute;
    writeProgram(folder.path("a.nc"), program, Dialect::Fanuc, header);
    EXPECT_NEAR(minutesOf(readProgram(folder.path("a.nc"), machine)) / program.report.minutes, 1.0, 0.01) << machine.name << ", Fanuc, G94";
  }
  EXPECT_GT(turns_alone, 100U);
}

TEST(TinyMoves, TheCheckOfThisTestSeesTheFault)
{
  const ScratchFolder folder;
  MachineProgram program = made(testMachines()[0], rollingPass(8));
  ProgramBlock block = program.blocks.back();
  block.rapid = false; // LinuxCNC's issue 2410: half a turn, 0.0002 mm and 0.2 minutes
  block.tip.z() -= 0.0002;
  block.angles.first += M_PI;
  block.minutes = 0.2;
  program.blocks.push_back(block);
  writeProgram(folder.path("a.ngc"), program, Dialect::LinuxCNC, {"fault", 0.0, 0, 4});
  EXPECT_EQ(hurriedMoves(parseFanuc(folder.path("a.ngc"))), 1U);
}

} // namespace tiny_moves_test
