// SPDX-License-Identifier: BSD-3-Clause
#include "control_moves.h"

#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double still = 1e-7; ///< mm and radians: no word of a program is finer

AxisValues
valuesOf(const ProgramBlock& block, bool tips)
{
  AxisValues values;
  values << (tips ? block.tip : block.machine), block.angles.first, block.angles.second;
  return values;
}

} // namespace

AxisDynamics
dynamicsOf(const Machine& machine)
{
  AxisDynamics axes;
  const auto set = [&axes](int i, const AxisRange& range, double usual) {
    axes.velocity[i] = range.largest_rate / 60.0;
    axes.acceleration[i] = range.largest_acceleration.value_or(usual);
    axes.jerk[i] = range.largest_jerk.value_or(std::numeric_limits<double>::infinity());
  };
  for (int i = 0; i < 3; ++i)
    set(i, machine.linear[i], usual_linear_acceleration);
  for (int i = 0; i < 2; ++i)
    set(3 + i, machine.rotary[i].range, usual_rotary_acceleration);
  return axes;
}

std::vector<ControlMove>
controlMoves(const MachineProgram& program, const ControlModel& control, const AxisDynamics& axes, double feed)
{
  std::vector<ControlMove> moves;
  moves.reserve(program.blocks.size());
  const bool tips = program.machine.takesTips() && !control.plans_axes, tip_length = program.machine.takesTips();
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock &from = program.blocks[i - 1], &to = program.blocks[i];
    const AxisValues way = valuesOf(to, tips) - valuesOf(from, tips);
    const double linear = tip_length ? (to.tip - from.tip).norm() : way.head<3>().norm();
    const double length = linear > still ? linear : way.tail<2>().norm();
    if (!(length > still))
      continue;
    const double asked = to.rapid ? std::numeric_limits<double>::infinity() : feed * length / (60.0 * to.minutes);
    ControlMove move = controlMove(way, length, asked, axes);
    move.rapid = to.rapid;
    move.turns = way.tail<2>().norm() > still;
    move.block = i;
    moves.push_back(move);
  }
  return moves;
}

} // namespace pcl_spiral
