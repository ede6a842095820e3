// SPDX-License-Identifier: BSD-3-Clause
// Whole programs in LinuxCNC's interpreter: kinematics, spindle and coolant at each motion, canonical feeds, and the
// joints of the machine's own kinematics module.
#include "support/canonical_run.h"
#include "support/control_scenes.h"
#include "support/linuxcnc_module.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace linuxcnc_whole_program_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** A machine of the scenes with its zero where the interpreter has it, which knows no offsets. */
Machine
zeroed(Machine machine)
{
  machine.work_zero.setZero();
  return machine;
}

struct WholeRun {
  CanonicalRun canon;
  ControlRun own;             ///< of the control of the tests, from the same text
  std::size_t length_off = 0; ///< line of the last G49
};

WholeRun
whole(const DomeScene& scene, const Machine& machine)
{
  const ScratchFolder folder;
  const std::string text = test::textOf(programOf(scene, machine), Dialect::LinuxCNC, headerOf());
  writeText(folder.path("part.ngc"), text);
  WholeRun run{interpret(folder.path("part.ngc"), folder, PCL_SPIRAL_MACHINES_DIR "/rs274", machine.tool_length),
               runProgram(text, Dialect::LinuxCNC, jobOf(scene, machine, Dialect::LinuxCNC)),
               static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.rfind("G49")), '\n') + 1)};
  EXPECT_EQ(run.canon.code, 0) << scene.name << ", " << machine.name;
  EXPECT_EQ(run.canon.messages, "") << scene.name << ", " << machine.name;
  EXPECT_EQ(run.own.fault, "") << scene.name << ", " << machine.name;
  return run;
}

/** X Y Z of the language at the end of a motion; \p length_off: the line from which on the tool length is off. */
Eigen::Vector3d
programmed(const Machine& machine, const ControlMotion& motion, std::size_t length_off)
{
  const double length = motion.line < length_off ? machine.tool_length : 0.0;
  return motion.tool_tip ? motion.at.tip : Eigen::Vector3d(motion.gauge - Eigen::Vector3d(0.0, 0.0, length));
}

/** Both read the same motions; F gives each feed move its time. */
void
expectTheSame(const Machine& machine, const WholeRun& run)
{
  ASSERT_EQ(run.canon.motions.size(), run.own.motions.size());
  std::size_t feeds = 0;
  bool at_tip = false;
  for (std::size_t i = 1; i < run.own.motions.size(); ++i) { // from the first retract on, before the tool is called
    const CanonicalMotion& canon = run.canon.motions[i];
    const ControlMotion &own = run.own.motions[i], &before = run.own.motions[i - 1];
    const Eigen::Vector3d to(canon.xyzabc[0], canon.xyzabc[1], canon.xyzabc[2]);
    const Eigen::Vector3d off = to - programmed(machine, own, run.length_off);
    at_tip = at_tip || own.tool_tip;
    const bool knows_place = own.tool_tip || !at_tip; // after M429 a machine reads its slides anew, the interpreter alone does not
    ASSERT_LT(knows_place ? off.norm() : std::abs(off.z()), 3e-4) << machine.name << ", line " << own.line;
    ASSERT_EQ(canon.rapid, own.rapid);
    ASSERT_EQ(canon.tool_tip, own.tool_tip) << machine.name << ", line " << own.line;
    for (int k = 0; k < 2 && !machine.three_axes; ++k)
      ASSERT_NEAR(canon.xyzabc[3 + static_cast<std::size_t>(machine.rotary[k].letter - 'A')], own.degrees[k], 1e-3);
    if (canon.rapid)
      continue;
    ++feeds;
    ASSERT_EQ(canon.spindle, 12000.0) << own.line;
    ASSERT_TRUE(canon.flood) << own.line;
    const double way = (programmed(machine, own, run.length_off) - programmed(machine, before, run.length_off)).norm();
    const double turn = std::hypot(own.degrees[0] - before.degrees[0], own.degrees[1] - before.degrees[1]);
    ASSERT_TRUE(way < 1e-7 || way > 5e-5) << "LinuxCNC takes the rotary axes' speed from such a way, line " << own.line;
    const double expected = (way > 1e-7 ? way : turn) / own.minutes;
    ASSERT_NEAR(canon.feed, expected, 1e-3 + 1e-4 * expected) << machine.name << ", line " << own.line;
    ASSERT_TRUE(canon.feed < 1.1 * 1500.0 || !(machine.takesTips() || machine.three_axes)) << machine.name << ", line " << own.line;
  }
  EXPECT_GT(feeds, 50U);
  EXPECT_EQ(run.canon.motions.back().rapid, true);
}

} // namespace

TEST(LinuxCNCWholeProgram, RunsWithItsFeeds)
{
  for (const DomeScene& scene : {spiralFromThePole(), finiteAxis(), threePasses(), bullNosePasses(), tiltedSpiral()})
    for (const DomeScene& way : {scene, reversed(scene)})
      for (const Machine& machine : limitedMachines(scene))
        expectTheSame(zeroed(machine), whole(way, zeroed(machine)));
}

TEST(LinuxCNCWholeProgram, ThreeAxes)
{
  expectTheSame(zeroed(threeAxisMill()), whole(uprightSpiral(), zeroed(threeAxisMill())));
}

TEST(LinuxCNCWholeProgram, TheMachinesOwnModuleMovesTheSameJoints)
{
  for (const std::size_t which : {0, 1}) { // xyzac, xyzbc
    Machine machine = zeroed(limitedMachines({})[0]);
    const double limit = machine.rotary[1].range.upper;
    machine.rotary = testMachines()[which].rotary;
    machine.rotary[1].range.lower = -limit;
    machine.rotary[1].range.upper = limit;
    const Eigen::Vector3d offset = which == 0 ? Eigen::Vector3d(0.0, 20.0, 10.0) : Eigen::Vector3d(15.0, 0.0, -8.0);
    machine.rotary[1].point = machine.rotary[0].point + offset;
    const char tilt = machine.rotary[1].letter;
    const LinuxCNCModule module(which == 0 ? "xyzac-trt-kins" : "xyzbc-trt-kins");
    ASSERT_TRUE(module.isThere()) << "LinuxCNC is missing; run cmake/install_dependencies.sh test";
    ASSERT_EQ(module.set(machine.rotary[0].point, offset, machine.tool_length), "");
    for (const DomeScene& scene : {spiralFromThePole(), threePasses()}) {
      const WholeRun run = whole(scene, machine);
      ASSERT_EQ(run.canon.motions.size(), run.own.motions.size());
      std::size_t checked = 0;
      for (std::size_t i = 0; i < run.own.motions.size(); ++i) {
        const auto& v = run.canon.motions[i].xyzabc;
        if (!run.canon.motions[i].tool_tip)
          continue;
        const std::size_t tilt_word = 3 + static_cast<std::size_t>(tilt - 'A');
        const std::array<double, 5> joints = module.inverse({v[0], v[1], v[2] + machine.tool_length}, tilt, v[tilt_word], v[5]);
        ASSERT_LT((Eigen::Vector3d(joints[0], joints[1], joints[2]) - run.own.motions[i].gauge).norm(), 1e-3) << run.own.motions[i].line;
        ++checked;
      }
      EXPECT_GT(checked, 100U);
    }
  }
}

} // namespace linuxcnc_whole_program_test
