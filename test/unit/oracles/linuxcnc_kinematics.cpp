// SPDX-License-Identifier: BSD-3-Clause
// The kinematics against LinuxCNC's own modules for trunnion tables.
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "support/linuxcnc_module.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <random>

namespace linuxcnc_kinematics_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

/** \p sense: of the module's angles, -1 if the machine counts them the other way. */
void
expectTheSame(const Machine& machine, const std::string& name, const Eigen::Vector3d& offset, double sense = 1.0)
{
  const LinuxCNCModule module(name);
  ASSERT_TRUE(module.isThere()) << name << " of LinuxCNC is missing; run cmake/install_dependencies.sh test";
  ASSERT_EQ(module.set(machine.rotary[0].point, offset, machine.tool_length), "");
  const Kinematics kinematics(machine);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-200.0, 200.0), tilt(-1.5, 1.5), turns(-300.0, 300.0);
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d tip(place(random), place(random), place(random));
    const RotaryAngles angles{turns(random), tilt(random)};
    const Eigen::Vector3d gauge = kinematics.gaugePoint(kinematics.programmed(tip, angles));
    const double degrees = sense * 180.0 / M_PI;
    const Eigen::Vector3d found = module.forward({gauge.x(), gauge.y(), gauge.z(), angles.second * degrees, angles.first * degrees});
    const Eigen::Vector3d back = found - Eigen::Vector3d(0.0, 0.0, machine.tool_length) - machine.work_zero;
    largest = std::max(largest, (back - tip).norm());
  }
  EXPECT_LT(largest, 1e-9);
}

} // namespace

TEST(LinuxCNCKinematics, XyzacTrunnionTable)
{
  Machine machine = testMachines()[0];
  const Eigen::Vector3d offset(0.0, 20.0, 10.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzac-trt-kins", offset);
}

TEST(LinuxCNCKinematics, XyzbcTrunnionTable)
{
  Machine machine = testMachines()[1];
  const Eigen::Vector3d offset(15.0, 0.0, -8.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzbc-trt-kins", offset);
}

// Newer modules have a pin conventional-directions, which Debian 12's have not: where it is set, every sine of an angle has the other
// sign, and a positive angle turns the table left-handed (LinuxCNC's pull request 3482). That is these modules at the negative angles.
TEST(LinuxCNCKinematics, WithConventionalDirectionsTheTablesTurnTheOtherWay)
{
  Machine machine = testMachines()[5];
  EXPECT_EQ(machine.rotary[0].direction, -Eigen::Vector3d::UnitZ());
  EXPECT_EQ(machine.rotary[1].direction, -Eigen::Vector3d::UnitX());
  Eigen::Vector3d offset(0.0, 20.0, 10.0);
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzac-trt-kins", offset, -1.0);
  machine = testMachines()[1];
  for (RotaryAxis& axis : machine.rotary)
    axis.direction *= -1.0;
  offset = {15.0, 0.0, -8.0};
  machine.rotary[1].point = machine.rotary[0].point + offset;
  expectTheSame(machine, "xyzbc-trt-kins", offset, -1.0);
}

} // namespace linuxcnc_kinematics_test
