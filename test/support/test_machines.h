// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Machines of every kind; every offset that can differ from zero does.
 */
#pragma once

#include "support/machine_oracle.h"

#include <pcl_spiral/machine/machine.h>

namespace pcl_spiral::test {

inline Machine
machineOf(const std::string& name, const RotaryAxis& first, const RotaryAxis& second)
{
  Machine machine;
  machine.name = name;
  machine.rotary = {first, second};
  for (RotaryAxis& axis : machine.rotary)
    axis.range.largest_rate = 40.0 * 2.0 * M_PI;
  machine.work_zero = {31.0, -17.0, 53.0};
  machine.tool_length = 120.0;
  return machine;
}

inline RotaryAxis
rotaryAxis(char letter, RotaryMount mount, const Eigen::Vector3d& direction, const Eigen::Vector3d& point)
{
  RotaryAxis axis;
  axis.letter = letter;
  axis.mount = mount;
  axis.direction = direction;
  axis.point = point;
  return axis;
}

/** Two tilting tables, a swivel head, a head over a table, a nutating head and a table that turns the
 * other way. */
inline std::vector<Machine>
testMachines()
{
  const RotaryMount table = RotaryMount::Table, head = RotaryMount::Head;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  return {machineOf("xyzac table table", rotaryAxis('C', table, z, {5, 7, 0}), rotaryAxis('A', table, x, {0, 27, 10})),
          machineOf("xyzbc table table", rotaryAxis('C', table, z, {-3, 2, 0}), rotaryAxis('B', table, y, {12, 0, -8})),
          machineOf("head head", rotaryAxis('C', head, z, {0, 0, 0}), rotaryAxis('B', head, y, {0.5, 0, 60})),
          machineOf("head table", rotaryAxis('C', table, z, {10, -20, 0}), rotaryAxis('B', head, y, {0, 0, 80})),
          machineOf("nutating head", rotaryAxis('C', head, z, {0, 0, 0}), rotaryAxis('B', head, {0, 1, 1}, {0, 30, 40})),
          machineOf("xyzac counted by the tool", rotaryAxis('C', table, -z, {5, 7, 0}), rotaryAxis('A', table, -x, {0, 27, 10}))};
}

inline MachineChain
chainOf(const Machine& machine)
{
  MachineChain chain;
  for (const RotaryAxis& axis :
       machine.three_axes ? std::vector<RotaryAxis>() : std::vector<RotaryAxis>(machine.rotary.begin(), machine.rotary.end()))
    chain.rotary.push_back({axis.letter, axis.mount == RotaryMount::Table, axis.direction, axis.point});
  chain.work_zero = machine.work_zero;
  chain.tool_length = machine.tool_length;
  return chain;
}

} // namespace pcl_spiral::test
