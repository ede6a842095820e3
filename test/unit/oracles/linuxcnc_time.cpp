// SPDX-License-Identifier: BSD-3-Clause
// The predicted time of programs beside that of LinuxCNC's own trajectory planner, which runs them in virtual time.
#include "support/control_scenes.h"
#include "support/linuxcnc_run.h"
#include "support/outlines.h"
#include "support/sampling.h"

#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace linuxcnc_time_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

constexpr std::size_t parts = 100; // of a program

/** A part, its size, and the machine. */
struct TimedCase {
  const char* part;
  double size;
  const char* machine;
  double tolerance = 0.01; ///< mm, of G64 P; 0: G61
};

Machine
machineOf(const TimedCase& one, double acceleration)
{
  Machine machine = readMachine(std::string(PCL_SPIRAL_MACHINES_DIR) + "/" + one.machine + ".yaml");
  machine.work_zero.setZero();
  machine.retract_z.reset();
  for (AxisRange& axis : machine.linear) {
    axis.lower = -1e6;
    axis.upper = 1e6;
    axis.largest_acceleration = acceleration;
  }
  for (RotaryAxis& axis : machine.rotary)
    axis.range.largest_acceleration = (axis.letter == 'C' ? 1000.0 : 500.0) * M_PI / 180.0;
  return machine;
}

LinuxCNCAxes
axesOf(const Machine& machine)
{
  LinuxCNCAxes axes;
  axes.velocity.fill(1e6);
  axes.acceleration.fill(1e6);
  for (std::size_t i = 0; i < 3; ++i) {
    axes.velocity[i] = machine.linear[i].largest_rate / 60.0;
    axes.acceleration[i] = *machine.linear[i].largest_acceleration;
  }
  for (const RotaryAxis& axis : machine.rotary) {
    if (machine.three_axes)
      break;
    const auto i = static_cast<std::size_t>(3 + axis.letter - 'A');
    axes.velocity[i] = axis.range.largest_rate / 60.0 * 180.0 / M_PI;
    axes.acceleration[i] = *axis.range.largest_acceleration * 180.0 / M_PI;
  }
  return axes;
}

SpiralPlan
planOf(const TimedCase& one, const Machine& machine)
{
  const std::string name = one.part;
  const SurfacePtr part =
      name == "dome" ? ball(60.0 * one.size, Region({circle({0, 0}, 50.0 * one.size)})) : outlinedPart(name, 0, one.size);
  SpiralPlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(toCloud(sampleUniform(*part, 8000, 5).points));
  planner.setToolRadius(5.0);
  planner.setScallopHeight(0.05);
  if (machine.three_axes)
    planner.setFixedAxis(Eigen::Vector3d::UnitZ());
  planner.compute();
  EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  return planner.getPlan();
}

MachineProgram
programAt(SpiralPlan plan, const Machine& machine, double feed)
{
  plan.settings.feed = feed;
  ProgramPlanner planner;
  planner.setInputPlan(plan);
  planner.setMachine(machine);
  planner.setCheckLeads(false);
  MachineProgram program;
  planner.compute(program);
  EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  return program;
}

/** The motions of \p program that LinuxCNC's interpreter reads from its text: as many as it has blocks. */
std::vector<CanonicalMotion>
motionsOf(const MachineProgram& program)
{
  const ScratchFolder folder;
  writeText(folder.path("part.ngc"), textOf(program, Dialect::LinuxCNC, headerOf()));
  CanonicalRun run = interpret(folder.path("part.ngc"), folder, PCL_SPIRAL_MACHINES_DIR "/rs274", program.machine.tool_length);
  if (run.code != 0 || run.motions.size() < program.blocks.size())
    throw std::runtime_error("rs274 gives " + std::to_string(run.motions.size()) + " motions: " + run.messages);
  run.motions.erase(run.motions.begin(), run.motions.end() - static_cast<std::ptrdiff_t>(program.blocks.size()));
  return run.motions;
}

/** Time in every hundredth of the way. */
std::array<double, parts>
inParts(const MachineProgram& program, const std::vector<double>& blocks)
{
  std::vector<double> way(program.blocks.size(), 0.0);
  for (std::size_t i = 1; i < way.size(); ++i)
    way[i] = way[i - 1] + (program.blocks[i].tip - program.blocks[i - 1].tip).norm();
  std::array<double, parts> times{};
  for (std::size_t i = 1; i < way.size(); ++i)
    times[std::min(parts - 1, static_cast<std::size_t>(static_cast<double>(parts) * way[i - 1] / way.back()))] += blocks[i];
  return times;
}

void
expectTheTime(const TimedCase& one, const MachineProgram& program)
{
  const LinuxCNCTime truth = runLinuxCNC(motionsOf(program), axesOf(program.machine), one.tolerance);
  ASSERT_EQ(truth.fault, "");
  const MotionTime predicted = *motionTime(program, controlModel(ControlKind::LinuxCNC), one.tolerance);
  std::vector<double> blocks(truth.ends.size(), 0.0);
  for (std::size_t i = 1; i < blocks.size(); ++i)
    blocks[i] = truth.ends[i] - truth.ends[i - 1];
  const auto true_parts = inParts(program, blocks), predicted_parts = inParts(program, predicted.blocks);
  std::size_t within = 0;
  for (std::size_t k = 0; k < parts; ++k)
    within += std::abs(predicted_parts[k] - true_parts[k]) <= 0.1 * true_parts[k] ? 1 : 0;
  std::printf("%-13s %-10s F %5g  at feed %8.2f s  LinuxCNC %8.2f s  predicted %8.2f s  %+.2f %%  %zu of 100\n", one.part, one.machine,
              program.feed, 60.0 * program.report.minutes, truth.seconds, predicted.seconds,
              100.0 * (predicted.seconds / truth.seconds - 1.0), within);
  EXPECT_NEAR(predicted.seconds / truth.seconds, 1.0, 0.02) << one.part << ", " << one.machine << ", " << program.feed;
  EXPECT_GE(within, 95U) << one.part << ", " << one.machine << ", " << program.feed;
}

void
expectTheTimes(const std::vector<TimedCase>& cases, double acceleration)
{
  ASSERT_TRUE(hasLinuxCNCPlanner()) << "LinuxCNC or its headers are missing; run cmake/install_dependencies.sh test, and configure anew";
  for (const TimedCase& one : cases) {
    const Machine machine = machineOf(one, acceleration);
    const SpiralPlan plan = planOf(one, machine);
    for (const double feed : {500.0, 3000.0, 10000.0})
      expectTheTime(one, programAt(plan, machine, feed));
  }
}

} // namespace

TEST(LinuxCNCTime, ThreeAxes)
{
  expectTheTimes({{"disc", 0.3, "three_axes"},
                  {"U", 0.5, "three_axes"},
                  {"cross", 0.5, "three_axes"},
                  {"star_pointed", 0.5, "three_axes"},
                  {"holes_3", 0.5, "three_axes"},
                  {"blade", 0.4, "three_axes"}},
                 1000.0);
}

TEST(LinuxCNCTime, FiveAxes)
{
  expectTheTimes({{"disc", 0.3, "xyzac"}, {"blade", 0.4, "xyzac"}, {"dome", 0.4, "xyzac"}, {"cross", 0.5, "xyzbc"}}, 1000.0);
}

TEST(LinuxCNCTime, OtherAccelerations)
{
  for (const double acceleration : {300.0, 5000.0})
    expectTheTimes({{"star_pointed", 0.5, "three_axes"}, {"dome", 0.4, "xyzac"}}, acceleration);
}

TEST(LinuxCNCTime, OtherTolerances)
{
  for (const double tolerance : {0.0, 0.001, 0.1})
    expectTheTimes({{"cross", 0.5, "three_axes", tolerance}, {"dome", 0.4, "xyzac", tolerance}}, 1000.0);
}

/** The outlines in full size; half a minute. */
TEST(LinuxCNCTime, DISABLED_FullSize)
{
  for (const char* machine : {"three_axes", "xyzac"})
    for (const char* part : {"disc", "U", "cross", "star_pointed", "star_smooth", "holes_3", "blade", "dome"})
      expectTheTimes({{part, 1.0, machine}}, 2000.0);
}

} // namespace linuxcnc_time_test
