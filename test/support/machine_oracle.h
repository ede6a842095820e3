// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Forward kinematics of five-axis machines, independent of the library: chains of 4x4 matrices from
 * the frame of the workpiece to the frame of the tool.
 */
#pragma once

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pcl_spiral::test {

/** One joint of a chain, at its place if every joint is at zero. */
struct ChainRotary {
  char letter;
  bool table;
  Eigen::Vector3d direction, point;
};

/** A machine as in its drawing. Table joints from the workpiece outward, head joints from the slides to
 * the tool. */
struct MachineChain {
  std::vector<ChainRotary> rotary; ///< from the workpiece to the tool; none: a three-axis machine
  Eigen::Vector3d work_zero = Eigen::Vector3d::Zero();
  double tool_length = 0.0;
};

/** X Y Z in mm and angles in degrees. */
struct AxisValues {
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  double first = 0.0, second = 0.0;
};

struct TipAndAxis {
  Eigen::Vector3d tip, axis;
};

/** The tool in the frame of the workpiece for programmed machine coordinates: X Y Z count from the zero of the
 * workpiece and include the tool length. */
inline TipAndAxis
forward(const MachineChain& chain, const AxisValues& at)
{
  using Pose = Eigen::Isometry3d;
  const auto about = [](const ChainRotary& joint, double degrees) {
    return Pose(Eigen::Translation3d(joint.point) * Eigen::AngleAxisd(degrees * M_PI / 180.0, joint.direction.normalized()) *
                Eigen::Translation3d(-joint.point));
  };
  const double angles[2] = {at.first, at.second};
  Pose work = Pose::Identity(); // machine <- table with the workpiece
  const int axes = static_cast<int>(chain.rotary.size());
  for (int i = axes - 1; i >= 0; --i)
    if (chain.rotary[i].table)
      work = work * about(chain.rotary[i], angles[i]);
  work = work * Eigen::Translation3d(chain.work_zero);
  const Eigen::Vector3d length(0.0, 0.0, chain.tool_length);
  Pose tool(Eigen::Translation3d(at.xyz + chain.work_zero + length)); // machine <- gauge point
  for (int i = 0; i < axes; ++i)
    if (!chain.rotary[i].table)
      tool = tool * about(chain.rotary[i], angles[i]);
  tool = tool * Eigen::Translation3d(-length);
  const Pose both = work.inverse() * tool;
  return {both.translation(), both.linear().col(2)};
}

} // namespace pcl_spiral::test
