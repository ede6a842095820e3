// SPDX-License-Identifier: BSD-3-Clause
// Kinematics of every kind of machine against chains of matrices.
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "core/angle_between.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <random>

namespace machine_kinematics_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double degrees = 180.0 / M_PI;

TipAndAxis
oracle(const Machine& machine, const Eigen::Vector3d& xyz, const RotaryAngles& angles)
{
  return forward(chainOf(machine), {xyz, angles.first * degrees, angles.second * degrees});
}

} // namespace

TEST(MachineKinematics, InverseThenTheOraclesForwardGivesTipAndAxisBack)
{
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const Machine& machine : testMachines()) {
    const Kinematics kinematics(machine);
    int reached = 0;
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d axis = Eigen::Vector3d(normal(random), normal(random), normal(random) + 1.0).normalized();
      const Eigen::Vector3d tip = 100.0 * Eigen::Vector3d(normal(random), normal(random), normal(random));
      for (Branch branch : {Branch::Larger, Branch::Smaller}) {
        const auto angles = kinematics.anglesOf(axis, branch);
        if (!angles)
          continue;
        ++reached;
        const Eigen::Vector3d xyz = kinematics.programmed(tip, *angles);
        const TipAndAxis found = oracle(machine, xyz, *angles);
        ASSERT_LT((found.tip - tip).norm(), 1e-9) << machine.name;
        ASSERT_LT(angleBetween(found.axis, axis), 1e-9) << machine.name;
        ASSERT_LT((kinematics.tipOf(xyz, *angles) - tip).norm(), 1e-9);
        ASSERT_LT(angleBetween(kinematics.toolAxis(*angles), axis), 1e-9);
      }
    }
    EXPECT_GT(reached, machine.name == "nutating head" ? 2500 : 3999) << machine.name;
  }
}

TEST(MachineKinematics, BranchesAreTheTwoOfTheBook)
{
  const Kinematics kinematics(testMachines()[0]);
  const double a = 0.4, c = 0.9; // u = (sin c sin a, cos c sin a, cos a)
  const Eigen::Vector3d axis(std::sin(c) * std::sin(a), std::cos(c) * std::sin(a), std::cos(a));
  const auto larger = kinematics.anglesOf(axis, Branch::Larger), smaller = kinematics.anglesOf(axis, Branch::Smaller);
  EXPECT_NEAR(larger->second, a, 1e-12);
  EXPECT_NEAR(larger->first, c, 1e-12);
  EXPECT_NEAR(smaller->second, -a, 1e-12);
  EXPECT_NEAR(std::remainder(smaller->first - c - M_PI, 2.0 * M_PI), 0.0, 1e-12);
}

TEST(MachineKinematics, ThePoleHasNoFirstAngle)
{
  for (const Machine& machine : testMachines()) {
    const auto angles = Kinematics(machine).anglesOf(Eigen::Vector3d::UnitZ(), Branch::Larger);
    ASSERT_TRUE(angles.has_value());
    EXPECT_TRUE(std::isnan(angles->first));
    EXPECT_NEAR(angles->second, 0.0, 1e-7);
  }
}

TEST(MachineKinematics, NutatingHeadsReachOnlySoFar)
{
  const Kinematics kinematics(testMachines()[4]); // 45 degrees: at most a right angle
  EXPECT_TRUE(kinematics.anglesOf(Eigen::Vector3d(1.0, 0.0, 0.01).normalized(), Branch::Larger).has_value());
  EXPECT_FALSE(kinematics.anglesOf(Eigen::Vector3d(1.0, 0.0, -0.01).normalized(), Branch::Larger).has_value());
}

TEST(MachineKinematics, MachinesThatCannotBeAreNamed)
{
  const auto said = [](const auto& change) {
    Machine machine = testMachines()[0];
    change(machine);
    const Status status = checkMachine(machine);
    EXPECT_FALSE(status.ok());
    EXPECT_THROW(Kinematics{machine}, std::invalid_argument);
    return status.message();
  };
  const auto has = [](const std::string& text, const std::string& part) { EXPECT_NE(text.find(part), std::string::npos) << text; };
  has(said([](Machine& m) { m.rotary[1].letter = 'C'; }), "both rotary axes are called C");
  has(said([](Machine& m) { m.rotary[1].letter = 'Q'; }), "use A, B or C");
  has(said([](Machine& m) { m.rotary[1].direction.setZero(); }), "direction of A is (0, 0, 0)");
  has(said([](Machine& m) { m.rotary[1].direction = {0, 0, -2}; }), "same direction");
  has(said([](Machine& m) { std::swap(m.rotary[0], m.rotary[1]); }), "from the workpiece to the tool");
  has(said([](Machine& m) { m.rotary[0].mount = RotaryMount::Head; }), "tables first");
  has(said([](Machine& m) { m.linear[2].lower = 5.0, m.linear[2].upper = 5.0; }), "lower limit of Z");
  has(said([](Machine& m) { m.rotary[0].home = 10.0, m.rotary[0].range.upper = 1.0; }), "home of C");
  has(said([](Machine& m) { m.rotary[0].range.largest_rate = std::numeric_limits<double>::infinity(); }), "max_rpm");
  has(said([](Machine& m) { m.tool_length = -1.0; }), "tool_length -1");
}

} // namespace machine_kinematics_test
