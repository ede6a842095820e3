// SPDX-License-Identifier: BSD-3-Clause
#include "limit_check.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/impl/kinematics.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double limit_rounding = 1e-6;

/** Blocks in which one axis is beyond a limit. */
struct Breach {
  std::size_t count = 0, first = 0;
  double first_value = 0.0, worst = 0.0, excess = 0.0;
  bool below = false;
};

std::array<double, 5>
axesOf(const Kinematics& kinematics, const ProgramBlock& block)
{
  const Eigen::Vector3d xyz = kinematics.gaugePoint(block.machine);
  return {xyz.x(), xyz.y(), xyz.z(), block.angles.first, block.angles.second};
}

Diagnostic
remedyOf(const RotaryAxis* rotary)
{
  if (rotary == nullptr)
    return "move the part (work_zero), or correct the limits in the machine file";
  return "turn the part, tilt the tool less, or correct the limits in the machine file";
}

Diagnostic
textOfBreach(const Diagnostic& place, const std::string& name, const Breach& breach, const AxisRange& range, const RotaryAxis* rotary)
{
  const double unit = rotary != nullptr ? in_degrees : 1.0;
  const char* const word = rotary != nullptr ? " {degrees}" : " {mm}";
  const double limit = (breach.below ? range.lower : range.upper) * unit;
  Diagnostic all =
      Diagnostic(place, ": ", name, " would be at ", breach.first_value * unit, word, ", ", std::abs(breach.first_value * unit - limit),
                 word, breach.below ? " below its lower" : " above its upper", " limit of ", limit, word);
  if (breach.count > 1)
    all += Diagnostic(" (", breach.count, " blocks, the worst at ", breach.worst * unit, word, ")");
  return Diagnostic(all, "; ", remedyOf(rotary));
}

} // namespace

Status
checkLimits(const Kinematics& kinematics, const std::vector<ProgramBlock>& blocks, const std::vector<std::size_t>& lines)
{
  const Machine& machine = kinematics.machine();
  std::array<Breach, 5> breaches;
  const auto rangeOf = [&machine](std::size_t axis) -> const AxisRange& {
    return axis < 3 ? machine.linear[axis] : machine.rotary[axis - 3].range;
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const std::array<double, 5> values = axesOf(kinematics, blocks[i]);
    for (std::size_t axis = 0; axis < 5; ++axis) {
      const AxisRange& range = rangeOf(axis);
      const double excess = std::max(range.lower - values[axis], values[axis] - range.upper);
      if (!(excess > limit_rounding))
        continue;
      Breach& breach = breaches[axis];
      if (breach.count++ == 0) {
        breach.first = i;
        breach.first_value = values[axis];
        breach.below = values[axis] < range.lower;
      }
      if (excess > breach.excess) {
        breach.excess = excess;
        breach.worst = values[axis];
      }
    }
  }
  Diagnostic all;
  for (std::size_t axis = 0; axis < 5; ++axis) {
    if (breaches[axis].count == 0)
      continue;
    const RotaryAxis* const rotary = axis < 3 ? nullptr : &machine.rotary[axis - 3];
    const std::string name(1, rotary != nullptr ? rotary->letter : "XYZ"[axis]);
    const std::size_t first = breaches[axis].first;
    const Diagnostic place = lines.empty() ? Diagnostic("block ", first + 1, " at ", blocks[first].arc_length, " {mm} of the path")
                                           : Diagnostic("line ", lines[first]);
    all += Diagnostic(all.empty() ? "" : "; ", textOfBreach(place, name, breaches[axis], rangeOf(axis), rotary));
  }
  return all.empty() ? Status::success() : Status(StatusCode::Failed, all);
}

} // namespace pcl_spiral
