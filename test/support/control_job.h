// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs for the controls of the tests.
 */
#pragma once

#include "support/control_run.h"
#include "support/test_machines.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

/** The shop has \p machine as its file says, and the control is set to it. */
inline ControlJob
jobOf(const Machine& machine)
{
  constexpr double degrees = 180.0 / M_PI;
  ControlJob job;
  job.real = job.set = chainOf(machine);
  for (int i = 0; i < 3; ++i)
    job.linear[i] = {machine.linear[i].lower, machine.linear[i].upper, machine.linear[i].largest_rate};
  for (std::size_t i = 0; i < job.real.rotary.size(); ++i) {
    const AxisRange& range = machine.rotary[i].range;
    job.rotary[i] = {range.lower * degrees, range.upper * degrees, range.largest_rate * degrees};
  }
  job.tool_tip = machine.rtcp && !job.real.rotary.empty();
  job.retract_z = machine.retract_z;
  return job;
}

/** Distance from a ball of radius \p sphere, with its top at zero, to a bull-nose or ball cutter of radius \p radius and
 *  corner radius \p corner with a shank of the same width, \p length mm from its tip. */
inline std::function<double(const TipAndAxis&)>
clearanceOfDome(double sphere, double radius, double corner, double length)
{
  return [=](const TipAndAxis& tool) {
    const Eigen::Vector3d to = Eigen::Vector3d(0.0, 0.0, -sphere) - tool.tip;
    const double height = to.dot(tool.axis), aside = (to - height * tool.axis).norm();
    return std::hypot(std::max(0.0, aside - (radius - corner)), std::max({0.0, corner - height, height - length})) - corner - sphere;
  };
}

} // namespace pcl_spiral::test
