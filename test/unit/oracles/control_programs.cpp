// SPDX-License-Identifier: BSD-3-Clause
// Whole programs of every language, run from their text by controls of the tests on machines of every kind.
#include "support/control_scenes.h"

#include <pcl_spiral/io/file_error.h>

#include <gtest/gtest.h>

namespace control_programs_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

void
expectRunsInEveryLanguage(const DomeScene& scene)
{
  for (const DomeScene& way : {scene, reversed(scene)})
    for (const Machine& machine : limitedMachines(scene)) {
      const MachineProgram program = programOf(way, machine);
      for (const DialectEntry& entry : dialect_entries)
        expectRuns(way, program, entry.dialect, headerOf(), jobOf(way, machine, entry.dialect));
    }
}

} // namespace

TEST(ControlPrograms, SpiralFromThePole)
{
  const MachineProgram program = programOf(spiralFromThePole(), limitedMachines({})[0]);
  EXPECT_FALSE(program.report.poles.empty());
  expectRunsInEveryLanguage(spiralFromThePole());
}

TEST(ControlPrograms, SeveralPasses)
{
  expectRunsInEveryLanguage(threePasses());
}

TEST(ControlPrograms, BullNosePasses)
{
  expectRunsInEveryLanguage(bullNosePasses());
}

TEST(ControlPrograms, AFiniteAxisTurnsBackAtTheTop)
{
  for (const DomeScene& way : {finiteAxis(), reversed(finiteAxis())})
    for (const Machine& machine : limitedMachines(way)) {
      const MachineProgram program = programOf(way, machine);
      EXPECT_GE(program.report.unwound_at.size(), 2U) << machine.name;
      for (const DialectEntry& entry : dialect_entries)
        if (entry.dialect != Dialect::FanucVectors)
          expectRuns(way, program, entry.dialect, headerOf(), jobOf(way, machine, entry.dialect));
      EXPECT_THROW(test::textOf(program, Dialect::FanucVectors, headerOf()), FileError) << "its words cannot turn an axis back";
    }
}

TEST(ControlPrograms, WithoutTipControl)
{
  for (const DomeScene& scene : {spiralFromThePole(), threePasses(), bullNosePasses()})
    for (const DomeScene& way : {scene, reversed(scene)})
      for (Machine machine : limitedMachines(scene)) {
        machine.rtcp = false;
        const MachineProgram program = programOf(way, machine);
        for (const Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc})
          expectRuns(way, program, dialect, headerOf(), jobOf(way, machine, dialect));
      }
}

TEST(ControlPrograms, ThreeAxes)
{
  for (const DomeScene& way : {uprightSpiral(), reversed(uprightSpiral())}) {
    const MachineProgram program = programOf(way, threeAxisMill());
    for (const Dialect dialect : {Dialect::LinuxCNC, Dialect::Fanuc, Dialect::Siemens, Dialect::Heidenhain}) {
      const std::string text = test::textOf(program, dialect, headerOf());
      for (const char* word : {" A", " B", " C", "M428", "TRAORI", "M128", "G43.4", "G93"})
        EXPECT_EQ(text.find(word + std::string(*word == ' ' ? "0" : "")), std::string::npos) << word;
      expectRuns(way, program, dialect, headerOf(), jobOf(way, threeAxisMill(), dialect));
    }
  }
}

TEST(ControlPrograms, OneFixedTilt)
{
  expectRunsInEveryLanguage(tiltedSpiral());
}

TEST(ControlPrograms, FeedsOfTheTip)
{
  ProgramHeader header = headerOf();
  header.feed_mode = FeedMode::PerMinute;
  for (const Machine& machine : limitedMachines({})) {
    const DomeScene scene = threePasses();
    const MachineProgram program = programOf(scene, machine);
    for (const Dialect dialect : {Dialect::Fanuc, Dialect::FanucVectors, Dialect::Siemens})
      expectRuns(scene, program, dialect, header, jobOf(scene, machine, dialect));
  }
}

TEST(ControlPrograms, NumbersOffsetsAndLinesOfTheShop)
{
  const DomeScene scene = threePasses();
  ProgramHeader header = headerOf();
  header.line_step = 10;
  header.spindle_direction = SpindleDirection::CounterClockwise;
  header.coolant = Coolant::Through;
  header.notes = {"scallop 0.05 mm"};
  for (Machine machine : limitedMachines(scene)) {
    machine.lines = {{"M64 P{tool}"}, {"M65 P1"}, {"M62 P0"}, {"M63 P0"}};
    machine.words.through = "M88";
    const MachineProgram program = programOf(scene, machine);
    for (const DialectEntry& entry : dialect_entries) {
      const bool klartext = entry.dialect == Dialect::Heidenhain;
      header.work_offset = klartext ? "2" : "G55";
      ControlJob job = jobOf(scene, machine, entry.dialect);
      job.offset = header.work_offset;
      job.clockwise = false;
      job.coolant = "M88";
      job.hooks = {"M64 P3", "M65 P1", "M62 P0", "M63 P0"};
      expectRuns(scene, program, entry.dialect, header, job);
      const ControlRun run = runProgram(test::textOf(program, entry.dialect, header), entry.dialect, job);
      ASSERT_EQ(run.hooks.size(), 2 + 2 * scene.passes.size()) << entry.word;
      EXPECT_EQ(run.hooks.front(), std::make_pair(std::string("M64 P3"), std::size_t(0)));
      EXPECT_EQ(run.hooks.back(), std::make_pair(std::string("M65 P1"), run.motions.size()));
      for (std::size_t i = 1; i + 1 < run.hooks.size(); ++i) { // each pass: at its first and its last point
        EXPECT_EQ(run.hooks[i].first, i % 2 == 1 ? "M62 P0" : "M63 P0");
        const ToolPoses& pass = scene.passes[(i - 1) / 2];
        EXPECT_LT((run.motions[run.hooks[i].second - 1].at.tip - (i % 2 == 1 ? pass.front() : pass.back()).tip).norm(), 1e-3);
      }
    }
  }
}

} // namespace control_programs_test
