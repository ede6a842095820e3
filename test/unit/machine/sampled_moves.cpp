// SPDX-License-Identifier: BSD-3-Clause
// The way of a ball between two blocks against the chain of matrices, closely sampled.
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/impl/sampled_moves.h>

#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace sampled_moves_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double arm = 8.0, tolerance = 1e-3;

ProgramBlock
blockAt(const Kinematics& kinematics, const Eigen::Vector3d& tip, const RotaryAngles& angles)
{
  ProgramBlock block;
  block.tip = tip;
  block.angles = angles;
  block.axis = block.normal = kinematics.toolAxis(angles);
  block.machine = kinematics.programmed(tip, angles);
  return block;
}

double
distanceTo(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector3d way = line[i] - line[i - 1];
    const double f = way.squaredNorm() > 0.0 ? std::clamp((p - line[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
    least = std::min(least, (p - line[i - 1] - f * way).norm());
  }
  return least;
}

/** The centre of the ball at share \p t, by the oracle: linear axes of the tip with RTCP, of the machine without. */
Eigen::Vector3d
centreAt(const Machine& machine, const ProgramBlock& a, const ProgramBlock& b, double t)
{
  const double first = (1.0 - t) * a.angles.first + t * b.angles.first, second = (1.0 - t) * a.angles.second + t * b.angles.second;
  TipAndAxis at = forward(chainOf(machine), {a.machine + t * (b.machine - a.machine), first * in_degrees, second * in_degrees});
  if (machine.rtcp)
    at.tip = a.tip + t * (b.tip - a.tip);
  return at.tip + arm * at.axis;
}

} // namespace

TEST(SampledMoves, TheBallStaysWithinTheToleranceOfTheSamples)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (Machine machine : testMachines())
    for (bool rtcp : {true, false})
      for (double turn : {0.01, 0.3, 2.0}) {
        machine.rtcp = rtcp;
        const Kinematics kinematics(machine);
        for (int trial = 0; trial < 5; ++trial) {
          const Eigen::Vector3d tip = 50.0 * Eigen::Vector3d(unit(random), unit(random), unit(random));
          const Eigen::Vector3d way = 4.0 * Eigen::Vector3d(unit(random), unit(random), unit(random));
          const RotaryAngles angles{unit(random), 0.8 * unit(random)};
          const ProgramBlock from = blockAt(kinematics, tip, angles);
          const ProgramBlock to =
              blockAt(kinematics, tip + way, {angles.first + turn * unit(random), angles.second + 0.4 * turn * unit(random)});
          std::vector<Eigen::Vector3d> line{from.tip + arm * from.axis};
          const ToolPoses poses = sampledMove(kinematics, from, to, {arm, tolerance, false});
          for (const ToolPose& pose : poses)
            line.push_back(pose.tip + arm * pose.axis);
          EXPECT_LT((poses.back().tip - to.tip).norm(), 1e-9);
          for (int k = 0; k <= 500; ++k)
            ASSERT_LT(distanceTo(line, centreAt(machine, from, to, k / 500.0)), 1.05 * tolerance) << machine.name << " " << rtcp << turn;
        }
      }
}

} // namespace sampled_moves_test
