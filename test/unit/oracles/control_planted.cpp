// SPDX-License-Identifier: BSD-3-Clause
// Faults planted into programs of every language: a control of the tests, or the comparison with the path, names each.
#include "support/control_scenes.h"
#include "support/planted_faults.h"
#include "support/reached_poses.h"

#include <gtest/gtest.h>

namespace control_planted_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** What is found: a refusal, a missed pose, or the wrong time. */
std::string
found(const ControlRun& run, const DomeScene& scene, const MachineProgram& program)
{
  if (!run.fault.empty())
    return run.fault;
  if (const std::string missed = missedPose(run, {scene.passes, scene.isBall() ? scene.radius : 0.0, program.report.poles});
      !missed.empty())
    return missed;
  return std::abs(feedMinutes(run) / program.report.minutes - 1.0) > 1e-3 ? "the time is not that of the program" : "";
}

} // namespace

TEST(ControlPlanted, EveryFaultIsNamed)
{
  const DomeScene scene = threePasses();
  for (const Machine& machine : limitedMachines(scene)) {
    const MachineProgram program = programOf(scene, machine);
    const std::string letters{std::min(machine.rotary[0].letter, machine.rotary[1].letter),
                              std::max(machine.rotary[0].letter, machine.rotary[1].letter)};
    for (const DialectEntry& entry : dialect_entries) {
      ProgramHeader header = headerOf();
      ControlJob job = jobOf(scene, machine, entry.dialect);
      if (entry.dialect == Dialect::Heidenhain)
        header.work_offset = job.offset = "1";
      const std::string good = test::textOf(program, entry.dialect, header);
      EXPECT_EQ(found(runProgram(good, entry.dialect, job), scene, program), "") << entry.word;
      for (const PlantedFault& fault : plantedFaults(entry.dialect, letters)) {
        const std::string text = withFault(good, entry.dialect, fault);
        ASSERT_NE(text, "") << entry.word << ": no place for: " << fault.name;
        const std::string said = found(runProgram(text, entry.dialect, job), scene, program);
        EXPECT_FALSE(said.empty()) << machine.name << ", " << entry.word << ": " << fault.name;
        EXPECT_NE(said.find(fault.words), std::string::npos) << machine.name << ", " << entry.word << ", " << fault.name << ": " << said;
      }
    }
  }
}

TEST(ControlPlanted, AToolOfAnotherLengthMissesThePath)
{
  const DomeScene scene = threePasses();
  for (const bool rtcp : {true, false})
    for (Machine machine : limitedMachines(scene)) {
      machine.rtcp = rtcp;
      const MachineProgram program = programOf(scene, machine);
      for (const DialectEntry& entry : dialect_entries) {
        if (entry.needs_rtcp && !rtcp)
          continue;
        const std::string text = test::textOf(program, entry.dialect, headerOf());
        for (const double by : {-1.0, 1.0}) {
          ControlJob job = jobOf(scene, machine, entry.dialect);
          job.first_step = 5.0;
          job.set.tool_length += by; // the tool table of the control is wrong
          const std::string said = found(runProgram(text, entry.dialect, job), scene, program);
          EXPECT_NE(said.find(by < 0.0 ? "enters the part" : "along the tool"), std::string::npos) << entry.word << by << ": " << said;
        }
        if (rtcp || machine.rotary[1].mount == RotaryMount::Table)
          continue;
        ControlJob job = jobOf(scene, machine, entry.dialect); // another tool than the machine file has, and the table is right
        job.first_step = job.gouge = 5.0;
        job.set.tool_length = job.real.tool_length = machine.tool_length + 1.0;
        EXPECT_NE(found(runProgram(text, entry.dialect, job), scene, program).find("is missed"), std::string::npos) << entry.word;
      }
    }
}

} // namespace control_planted_test
