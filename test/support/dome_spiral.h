// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A spiral over an exact sphere.
 */
#pragma once

#include <pcl_spiral/machine/impl/tool_pose.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral::test {

/** \p turns turns of a ball cutter of radius \p ball, \p pitch mm apart in arc length, from the pole of a
 * sphere of radius \p sphere down; the axis is tilted \p tilt degrees from the normal to the side of the travel,
 * starting gradually over the first \p ease mm from the pole. */
inline ToolPoses
domeSpiral(double sphere, double pitch, int turns, int poses_a_turn, double ball, double tilt, double ease = 10.0)
{
  ToolPoses poses;
  for (int i = 0; i <= turns * poses_a_turn; ++i) {
    const double turn = static_cast<double>(i) / poses_a_turn, round = 2.0 * M_PI * turn;
    const double polar = pitch * turn / sphere;
    ToolPose pose;
    pose.normal = {std::sin(polar) * std::cos(round), std::sin(polar) * std::sin(round), std::cos(polar)};
    const Eigen::Vector3d travel(-std::sin(round), std::cos(round), 0.0);
    const double lean = tilt * M_PI / 180.0 * std::min(1.0, sphere * polar / ease);
    pose.axis = Eigen::AngleAxisd(lean, travel) * pose.normal;
    pose.contact = sphere * pose.normal - Eigen::Vector3d(0.0, 0.0, sphere);
    pose.tip = pose.contact + ball * (pose.normal - pose.axis);
    poses.push_back(pose);
  }
  return poses;
}

} // namespace pcl_spiral::test
