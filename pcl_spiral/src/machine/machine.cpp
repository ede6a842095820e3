// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/machine.h>

#include <Eigen/Geometry>

namespace pcl_spiral {
namespace {

constexpr double least_limit = 1e-3, largest_limit = 1e9; // of acceleration and jerk: machines have 100 to 1e6, mm or degrees

Status
fault(const Machine& machine, const Diagnostic& what)
{
  return {StatusCode::InvalidArgument, Diagnostic(machine.name.empty() ? std::string("machine") : machine.name, ": ", what)};
}

/** \p unit: mm or radians in one of the units that machine files have. */
Diagnostic
rangeFault(const std::string& axis, const AxisRange& range, double unit)
{
  if (!(range.lower < range.upper))
    return Diagnostic("the lower limit of ", axis, " is not below the upper one; give limits: [lower, upper]");
  if (!(range.largest_rate > 0.0))
    return Diagnostic("the largest rate of ", axis, " is ", range.largest_rate, "; it must be above 0");
  const auto isBad = [unit](const std::optional<double>& limit) {
    return limit && !(*limit >= least_limit * unit && *limit <= largest_limit * unit);
  };
  const auto text = [&](const char* name, double limit, const char* without) {
    return Diagnostic(name, axis, " is ", limit / unit, "; give a number from 0.001 to 1000000000, or leave it out for ", without);
  };
  if (isBad(range.largest_acceleration))
    return text("the largest acceleration of ", *range.largest_acceleration, "the usual one");
  if (isBad(range.largest_jerk))
    return text("the largest jerk of ", *range.largest_jerk, "none");
  return {};
}

Diagnostic
rotaryFault(const RotaryAxis& axis)
{
  if (axis.letter != 'A' && axis.letter != 'B' && axis.letter != 'C')
    return Diagnostic("a rotary axis is called ", axis.letter, "; use A, B or C");
  if (!axis.direction.allFinite() || !(axis.direction.norm() > 1e-9))
    return Diagnostic("the direction of ", axis.letter, " is ", Place(axis.direction), "; give one such as [1, 0, 0]");
  if (!axis.point.allFinite())
    return Diagnostic("the point of ", axis.letter, " is not finite; give one such as [0, 0, 0]");
  if (!std::isfinite(axis.range.largest_rate))
    return Diagnostic("no largest rate of ", axis.letter, " is given; give max_rpm, such as 20");
  if (const Diagnostic what = rangeFault(std::string(1, axis.letter), axis.range, pi / 180.0); !what.empty())
    return what;
  if (!(axis.home >= axis.range.lower && axis.home <= axis.range.upper))
    return Diagnostic("home of ", axis.letter, " lies beyond its limits; give a value within them");
  return {};
}

Status
checkRotary(const Machine& machine)
{
  for (const RotaryAxis& axis : machine.rotary)
    if (const Diagnostic what = rotaryFault(axis); !what.empty())
      return fault(machine, what);
  const auto& [first, second] = machine.rotary;
  if (first.letter == second.letter)
    return fault(machine, Diagnostic("both rotary axes are called ", first.letter, "; give each its own letter"));
  if (first.mount == RotaryMount::Head && second.mount == RotaryMount::Table)
    return fault(machine, Diagnostic("the table ", second.letter, " comes after the head ", first.letter,
                                     "; list rotary axes in the order from the workpiece to the tool, tables first"));
  if (!(first.direction.normalized().cross(second.direction.normalized()).norm() > 1e-3))
    return fault(machine, Diagnostic(first.letter, " and ", second.letter,
                                     " turn about the same direction; tilting a tool needs two different directions"));
  if (!(second.direction.normalized().cross(Eigen::Vector3d::UnitZ()).norm() > 1e-3))
    return fault(machine, Diagnostic(second.letter, ", the axis nearer to the tool, turns about the tool itself; list rotary "
                                                    "axes in the order from the workpiece to the tool"));
  return Status::success();
}

} // namespace

Machine
xyzacTrunnion()
{
  Machine machine;
  machine.name = "xyzac-trt";
  machine.rotary[0].letter = 'C';
  machine.rotary[0].direction = Eigen::Vector3d::UnitZ();
  machine.rotary[1].letter = 'A';
  machine.rotary[1].direction = Eigen::Vector3d::UnitX();
  for (RotaryAxis& axis : machine.rotary)
    axis.range.largest_rate = 30.0 * 2.0 * pi;
  return machine;
}

Status
checkMachine(const Machine& machine)
{
  for (int i = 0; i < 3; ++i)
    if (const Diagnostic what = rangeFault(std::string(1, "XYZ"[i]), machine.linear[i], 1.0); !what.empty())
      return fault(machine, what);
  if (!machine.three_axes)
    if (const Status status = checkRotary(machine); !status.ok())
      return status;
  if (!machine.work_zero.allFinite() || !(machine.tool_length >= 0.0) || !std::isfinite(machine.tool_length))
    return fault(machine, Diagnostic("work_zero ", Place(machine.work_zero), " and tool_length ", machine.tool_length,
                                     " must be finite, the length not below 0"));
  const AxisRange& z = machine.linear[2];
  if (machine.retract_z && !(*machine.retract_z >= z.lower && *machine.retract_z <= z.upper))
    return fault(machine, Diagnostic("retract_z is ", *machine.retract_z, ", beyond the limits of Z, ", z.lower, " to ", z.upper,
                                     "; give a height within them that is clear of everything"));
  if (const double tolerance = machine.path_tolerance.value_or(0.0); !(tolerance >= 0.0) || !std::isfinite(tolerance))
    return fault(machine, Diagnostic("path_tolerance is ", tolerance, "; it must be 0 {mm} or above"));
  if (machine.control.look_ahead && *machine.control.look_ahead < 1)
    return fault(machine, Diagnostic("the look-ahead of the control is ", *machine.control.look_ahead, " moves; it must be 1 or above"));
  if (machine.words.tip_control_on.empty() != machine.words.tip_control_off.empty())
    return fault(machine, "of the two words that switch the kinematics only one is given; give both, such as M428 and M429");
  return Status::success();
}

} // namespace pcl_spiral
