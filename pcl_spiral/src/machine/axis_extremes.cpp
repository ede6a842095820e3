// SPDX-License-Identifier: BSD-3-Clause
#include "machine/axis_extremes.h"

#include <pcl_spiral/machine/impl/kinematics.h>

#include <algorithm>
#include <functional>

namespace pcl_spiral {
namespace {

using ValueOfBlock = std::function<double(const ProgramBlock&)>;

void
addExtremes(const std::vector<ProgramBlock>& blocks, char letter, bool rotary, const AxisRange& range, const ValueOfBlock& valueOf,
            std::vector<AxisExtreme>& extremes)
{
  const auto isBelow = [&](const ProgramBlock& a, const ProgramBlock& b) { return valueOf(a) < valueOf(b); };
  const auto add = [&](bool largest, std::vector<ProgramBlock>::const_iterator at, double limit) {
    extremes.push_back({letter, rotary, largest, static_cast<std::size_t>(at - blocks.begin()), valueOf(*at), limit});
  };
  add(false, std::min_element(blocks.begin(), blocks.end(), isBelow), range.lower);
  add(true, std::max_element(blocks.begin(), blocks.end(), isBelow), range.upper);
}

} // namespace

std::vector<AxisExtreme>
axisExtremes(const MachineProgram& program)
{
  std::vector<AxisExtreme> extremes;
  if (program.blocks.empty())
    return extremes;
  const Kinematics kinematics(program.machine);
  const Machine& machine = program.machine;
  for (int i = 0; i < 3; ++i)
    addExtremes(
        program.blocks, "XYZ"[i], false, machine.linear[i],
        [&, i](const ProgramBlock& block) { return kinematics.gaugePoint(block.machine)[i]; }, extremes);
  if (machine.three_axes)
    return extremes;
  addExtremes(
      program.blocks, machine.rotary[0].letter, true, machine.rotary[0].range, [](const ProgramBlock& block) { return block.angles.first; },
      extremes);
  addExtremes(
      program.blocks, machine.rotary[1].letter, true, machine.rotary[1].range,
      [](const ProgramBlock& block) { return block.angles.second; }, extremes);
  return extremes;
}

} // namespace pcl_spiral
