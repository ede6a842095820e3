// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_scenes.h"
#include "support/shortest_block.h"

#include "support/control_job.h"
#include "support/dome_spiral.h"
#include "support/reached_poses.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl_spiral::test {
namespace {

constexpr double radians = M_PI / 180.0, feed = 1500.0;

/** A cutter that touches \p contact, with the axis \p axis. */
ToolPose
touching(const Eigen::Vector3d& contact, const Eigen::Vector3d& normal, const Eigen::Vector3d& axis, double radius, double corner)
{
  ToolPose pose;
  pose.contact = contact;
  pose.normal = normal;
  pose.axis = axis;
  const Eigen::Vector3d aside = normal - normal.dot(axis) * axis;
  pose.tip = contact + corner * (normal - axis);
  if (radius > corner)
    pose.tip += (radius - corner) * aside.normalized();
  return pose;
}

ToolPoses
cut(const ToolPoses& all, std::size_t first, std::size_t last)
{
  return ToolPoses(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last));
}

/** The spiral of \p scene with another tool axis. */
DomeScene
withAxis(DomeScene scene, const Eigen::Vector3d& axis)
{
  for (ToolPoses& pass : scene.passes)
    for (ToolPose& pose : pass)
      pose = touching(pose.contact, pose.normal, axis, scene.radius, scene.corner);
  return scene;
}

} // namespace

DomeScene
spiralFromThePole()
{
  return {"spiral from the pole", {domeSpiral(200.0, 2.0, 6, 60, 6.0, 13.0)}};
}

DomeScene
finiteAxis()
{
  DomeScene scene{"finite axis", {cut(domeSpiral(200.0, 2.0, 11, 60, 6.0, 13.0), 300, 660)}};
  scene.lower = -400.0;
  scene.upper = 350.0;
  return scene;
}

DomeScene
threePasses()
{
  const ToolPoses all = domeSpiral(200.0, 4.0, 12, 60, 6.0, 13.0);
  return {"three passes", {cut(all, 300, 421), cut(all, 480, 511), cut(all, 600, 661)}};
}

DomeScene
bullNosePasses()
{
  DomeScene scene{"bull-nose passes", {}};
  scene.radius = 8.0;
  scene.corner = 2.0;
  for (const double row : {30.0, 33.0, 36.0}) {
    ToolPoses pass;
    for (int i = -20; i <= 20; ++i) {
      const Eigen::Vector3d normal = Eigen::Vector3d(2.0 * i, row, 180.0).normalized(), travel = Eigen::Vector3d::UnitX();
      const Eigen::Vector3d axis = Eigen::AngleAxisd(-12.0 * radians, normal.cross(travel).normalized()) * normal;
      pass.push_back(touching(scene.sphere * (normal - Eigen::Vector3d::UnitZ()), normal, axis, scene.radius, scene.corner));
    }
    scene.passes.push_back(pass);
  }
  return scene;
}

DomeScene
uprightSpiral()
{
  DomeScene scene = withAxis(spiralFromThePole(), Eigen::Vector3d::UnitZ());
  scene.name = "upright spiral";
  return scene;
}

DomeScene
tiltedSpiral()
{
  DomeScene scene = withAxis(spiralFromThePole(), Eigen::Vector3d(0.2, 0.3, 1.0).normalized());
  scene.name = "tilted spiral";
  return scene;
}

DomeScene
reversed(DomeScene scene)
{
  scene.name += ", from the other end";
  std::reverse(scene.passes.begin(), scene.passes.end());
  for (ToolPoses& pass : scene.passes)
    std::reverse(pass.begin(), pass.end());
  return scene;
}

std::vector<Machine>
limitedMachines(const DomeScene& scene)
{
  const std::vector<Machine> all = testMachines();
  std::vector<Machine> machines = {all[0], all[2], all[3], all[4]};
  for (Machine& machine : machines) {
    for (AxisRange& axis : machine.linear)
      axis = {-600.0, 600.0, 20000.0};
    machine.rotary[0].range.lower = scene.lower * radians;
    machine.rotary[0].range.upper = scene.upper * radians;
    machine.rotary[1].range.lower = -110.0 * radians;
    machine.rotary[1].range.upper = 110.0 * radians;
    machine.retract_z = 500.0;
    machine.words.tip_control_on = "M428";
    machine.words.tip_control_off = "M429";
  }
  return machines;
}

Machine
threeAxisMill()
{
  Machine machine = limitedMachines({})[0];
  machine.name = "three axes";
  machine.three_axes = true;
  machine.rotary = {};
  machine.words = {};
  return machine;
}

MachineProgram
programOf(const DomeScene& scene, const Machine& machine)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses(scene.passes);
  ProgramSettings settings;
  settings.feed = feed;
  settings.ball_radius = scene.isBall() ? scene.radius : 0.0;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << scene.name << ", " << machine.name << ": " << generator.getStatus().message();
  return program;
}

ProgramHeader
headerOf()
{
  ProgramHeader header;
  header.title = "part (dome)";
  header.spindle_speed = 12000.0;
  header.tool = 3;
  header.coolant = Coolant::Flood;
  return header;
}

std::string
textOf(const MachineProgram& program, Dialect dialect, const ProgramHeader& header)
{
  const ScratchFolder folder;
  writeProgram(folder.path("part.nc"), program, dialect, header);
  return readText(folder.path("part.nc"));
}

ControlJob
jobOf(const DomeScene& scene, const Machine& machine, Dialect dialect)
{
  ControlJob job = jobOf(machine);
  job.tool = 3;
  job.coolant = "M8";
  job.largest_feed = 1.1 * feed;
  job.gouge = 0.015; // chords of 4 mm on the dome are 0.0112 mm deep, and blocks leave them by 0.002 mm
  job.clearance = clearanceOfDome(scene.sphere, scene.radius, scene.corner, 80.0);
  if (dialect == Dialect::Heidenhain)
    job.offset.clear();
  return job;
}

double
writtenMinutes(const MachineProgram& program, Dialect dialect, const std::string& text)
{
  const double shortest = text.find("\nG93\n") != std::string::npos ? shortestBlock(dialect) : 0.0;
  double minutes = program.report.minutes;
  for (const ProgramBlock& block : program.blocks)
    if (!block.rapid)
      minutes += std::max(0.0, shortest - block.minutes);
  return minutes;
}

void
expectRuns(const DomeScene& scene, const MachineProgram& program, Dialect dialect, const ProgramHeader& header, const ControlJob& job)
{
  const std::string text = textOf(program, dialect, header);
  const ControlRun run = runProgram(text, dialect, job);
  const std::string what = scene.name + ", " + program.machine.name + ", " + entryOf(dialect).word;
  EXPECT_EQ(run.fault, "") << what << "\n" << text.substr(0, 1500);
  if (!run.fault.empty())
    return;
  EXPECT_EQ(missedPose(run, {scene.passes, scene.isBall() ? scene.radius : 0.0, program.report.poles}), "") << what;
  EXPECT_EQ(missedBlock(run, program), "") << what;
  EXPECT_NEAR(feedMinutes(run) / writtenMinutes(program, dialect, text), 1.0, 1e-3) << what;
}

} // namespace pcl_spiral::test
