// SPDX-License-Identifier: BSD-3-Clause
// LinuxCNC programs: run by its own interpreter, and the canonical motions compared with the path.
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "core/angle_between.h"
#include "support/canonical_run.h"
#include "support/dome_spiral.h"
#include "support/scratch_folder.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

namespace linuxcnc_program_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

double
word(const Machine& machine, const CanonicalMotion& motion, int rotary)
{
  return motion.xyzabc[3 + (machine.rotary[rotary].letter - 'A')];
}

/** Tip and axis of the motion with the kinematics of this test. */
TipAndAxis
where(const Machine& machine, const CanonicalMotion& motion)
{
  AxisValues values{{motion.xyzabc[0], motion.xyzabc[1], motion.xyzabc[2]}, word(machine, motion, 0), word(machine, motion, 1)};
  TipAndAxis found = forward(chainOf(machine), values);
  if (machine.rtcp)
    found.tip = values.xyz;
  return found;
}

void
expectPath(const Machine& machine, const CanonicalRun& run, const MachineProgram& program, const ToolPoses& poses)
{
  std::size_t at = 0, poles_end = program.report.poles.empty() ? 0 : program.report.poles.back().last_pose + 1;
  std::vector<const CanonicalMotion*> cuts;
  for (const CanonicalMotion& motion : run.motions)
    if (!motion.rapid)
      cuts.push_back(&motion);
  double tip = 0.0, axis = 0.0;
  for (std::size_t i = poles_end; i < poses.size(); ++i) { // every pose is passed, in order
    while (at < cuts.size()) {
      const TipAndAxis found = where(machine, *cuts[at]);
      const double off = (found.tip - poses[i].tip).norm(), angle = angleBetween(found.axis, poses[i].axis) * 180.0 / M_PI;
      if (off < 1e-3 && angle < 1e-3) {
        tip = std::max(tip, off);
        axis = std::max(axis, angle);
        break;
      }
      ++at;
    }
    ASSERT_LT(at, cuts.size()) << machine.name << ": pose " << i << " is not on the program's way";
  }
  std::printf("%s: %zu motions, tip within %.2g mm, axis within %.2g degrees\n", machine.name.c_str(), run.motions.size(), tip, axis);
}

/** Every feed motion takes the time of its block, by the speed that the interpreter sets. */
void
expectTimes(const CanonicalRun& run, const MachineProgram& program)
{
  std::vector<const ProgramBlock*> blocks;
  for (const ProgramBlock& block : program.blocks)
    if (!block.rapid)
      blocks.push_back(&block);
  std::size_t at = 0;
  double largest = 0.0;
  for (std::size_t i = 1; i < run.motions.size(); ++i) {
    if (run.motions[i].rapid)
      continue;
    ASSERT_LT(at, blocks.size());
    const double minutes = minutesOf(run.motions[i - 1], run.motions[i]);
    if (minutes > 0.0) // else nothing moves, in 4 decimals
      largest = std::max(largest, std::abs(minutes / blocks[at]->minutes - 1.0));
    ++at;
  }
  EXPECT_EQ(at, blocks.size());
  EXPECT_LT(largest, 1e-5);
  std::printf("times of %zu blocks within %.2g\n", at, largest);
}

} // namespace

TEST(LinuxCNC, DomeSpiralOfHundredTurnsRuns)
{
  const ScratchFolder folder;
  const ToolPoses poses = domeSpiral(400.0, 2.0, 105, 90, 8.0, 15.0);
  for (Machine machine : testMachines())
    for (const bool rtcp : {true, false}) {
      if (!rtcp && machine.name != "xyzac table table")
        continue; // four times the blocks
      machine.rtcp = rtcp;
      machine.retract_z = 900.0;
      MachineProgramGenerator generator;
      generator.setMachine(machine);
      generator.setInputPoses(poses);
      ProgramSettings settings;
      settings.ball_radius = 8.0;
      generator.setSettings(settings);
      MachineProgram program;
      generator.compute(program);
      ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
      const std::string file = folder.path("dome.ngc");
      writeLinuxCNC(file, program, {"dome (spiral)", 12000.0, 0, 4});
      const CanonicalRun run = interpret(file, folder);
      EXPECT_EQ(run.code, 0);
      EXPECT_EQ(run.messages, "");
      expectPath(machine, run, program, poses);
      expectTimes(run, program);
      double lowest = 0.0, highest = 0.0, largest = 0.0;
      for (std::size_t i = 1; i < run.motions.size(); ++i) {
        const double c = word(machine, run.motions[i], 0);
        lowest = std::min(lowest, c);
        highest = std::max(highest, c);
        largest = std::max(largest, std::abs(c - word(machine, run.motions[i - 1], 0)));
      }
      EXPECT_GT(highest - lowest, 103.0 * 360.0) << "unwound, never folded";
      EXPECT_LT(largest, 180.0);
    }
}

} // namespace linuxcnc_program_test
