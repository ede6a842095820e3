// SPDX-License-Identifier: BSD-3-Clause
// Poses of a cutter that is not a ball go to the machine as they are, also at its pole: slower where an axis needs it.
#include <pcl_spiral/machine/machine_program_generator.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/machine_way.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pole_without_ball_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** A pass straight over a dome of radius 200 mm, \p offset mm beside its pole; the axis is the normal. */
ToolPoses
passBesideThePole(double offset)
{
  ToolPoses poses;
  for (int i = -300; i <= 300; ++i) {
    ToolPose pose;
    const double x = 0.1 * i / 200.0, y = offset / 200.0;
    pose.normal = pose.axis = Vector3d(x, y, std::sqrt(1.0 - x * x - y * y));
    pose.contact = pose.tip = 200.0 * pose.normal;
    poses.push_back(pose);
  }
  return poses;
}

/** The largest distance of the cutting way from the poses in order: of the tip, mm, and of the axis, radians. */
std::pair<double, double>
farthestOff(const MachineProgram& program, const ToolPoses& poses)
{
  std::pair<double, double> off{0.0, 0.0};
  for (const ToolPose& pose : poses) {
    double tip = 1e9, axis = 1e9;
    for (const ProgramBlock& block : program.blocks)
      if ((block.tip - pose.tip).norm() < tip) {
        tip = (block.tip - pose.tip).norm();
        axis = angleBetween(block.axis, pose.axis);
      }
    off = {std::max(off.first, tip), std::max(off.second, axis)};
  }
  return off;
}

MachineProgram
made(const Machine& machine, const ToolPoses& poses, double ball_radius)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(poses);
  ProgramSettings settings; // the cone is its default
  settings.ball_radius = ball_radius;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

} // namespace

TEST(PoleWithoutBall, TheAxisStaysAndTheBlocksAreSlower)
{
  for (const double offset : {0.1, 0.5})
    for (const Machine& machine : testMachines()) {
      const ToolPoses poses = passBesideThePole(offset);
      const MachineProgram program = made(machine, poses, 0.0);
      EXPECT_TRUE(program.report.poles.empty());
      const auto [tip, axis] = farthestOff(program, poses);
      EXPECT_LT(tip, 1e-9) << machine.name;
      EXPECT_LT(axis, 1e-9) << machine.name;
      EXPECT_GT(program.report.slowed_blocks, 0U) << machine.name;
      for (std::size_t i = 1; i < program.blocks.size(); ++i) {
        const ProgramBlock &from = program.blocks[i - 1], &to = program.blocks[i];
        if (to.section != BlockSection::Cut)
          continue;
        for (const auto angle : {&RotaryAngles::first, &RotaryAngles::second}) {
          const double rate = machine.rotary[angle == &RotaryAngles::first ? 0 : 1].range.largest_rate;
          ASSERT_LE(std::abs(to.angles.*angle - from.angles.*angle), rate * to.minutes * (1.0 + 1e-9));
        }
      }
      const MachineProgram blended = made(machine, poses, 5.0);
      EXPECT_FALSE(blended.report.poles.empty()) << "the pole is near enough for a ball";
      EXPECT_GT(farthestOff(blended, poses).second, 1e-4);
    }
}

TEST(PoleWithoutBall, TheRadiusOfThePathCountsInAnyOrder)
{
  pcl::PointCloud<ToolpathPoint> path;
  for (const ToolPose& pose : passBesideThePole(0.3)) {
    ToolpathPoint p;
    p.getVector3fMap() = pose.contact.cast<float>();
    p.getNormalVector3fMap() = p.getAxisVector3fMap() = pose.normal.cast<float>();
    p.arc_length = path.empty() ? 0.0f : path.back().arc_length + (p.getVector3fMap() - path.back().getVector3fMap()).norm();
    path.push_back(p);
  }
  MachineProgram programs[2];
  for (const bool settings_last : {false, true}) {
    MachineProgramGenerator generator;
    generator.setMachine(testMachines().front());
    ProgramSettings settings;
    settings.lead_length = 3.0;
    if (!settings_last)
      generator.setSettings(settings);
    generator.setInputPath(path, 5.0);
    if (settings_last)
      generator.setSettings(settings);
    generator.compute(programs[settings_last]);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    settings.ball_radius = 4.0;
    generator.setSettings(settings);
    MachineProgram none;
    generator.compute(none);
    EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
    EXPECT_NE(generator.getStatus().message().find("5 mm in setInputPath and 4 mm in setSettings"), std::string::npos)
        << generator.getStatus().message();
    generator.setInputPoses(ballPoses(path, 4.0)); // poses have no radius of their own
    generator.compute(none);
    EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  }
  EXPECT_FALSE(programs[0].report.poles.empty());
  ASSERT_EQ(programs[0].blocks.size(), programs[1].blocks.size());
  for (std::size_t i = 0; i < programs[0].blocks.size(); ++i)
    ASSERT_TRUE(programs[0].blocks[i].tip == programs[1].blocks[i].tip && programs[0].blocks[i].axis == programs[1].blocks[i].axis);
}

} // namespace pole_without_ball_test
