// SPDX-License-Identifier: BSD-3-Clause
#include "verify/program_pace.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t neighbours = 5;
constexpr double most = 1.4;

/** Speed of the ball's centre on each block, mm/min; 0 on blocks that do not cut. */
std::vector<double>
speedsOf(const MachineProgram& program, double radius)
{
  const std::vector<ProgramBlock>& blocks = program.blocks;
  std::vector<double> speeds(blocks.size(), 0.0);
  for (std::size_t i = 1; i < blocks.size(); ++i)
    if (blocks[i].section == BlockSection::Cut && blocks[i].minutes > 0.0)
      speeds[i] = (blocks[i].tip + radius * blocks[i].axis - blocks[i - 1].tip - radius * blocks[i - 1].axis).norm() / blocks[i].minutes;
  return speeds;
}

/** The median of the speeds of neighbours from \p begin on; 0 if one of them does not cut. */
double
medianOf(const std::vector<double>& speeds, std::size_t begin)
{
  std::vector<double> some(speeds.begin() + static_cast<std::ptrdiff_t>(begin),
                           speeds.begin() + static_cast<std::ptrdiff_t>(begin + neighbours));
  std::sort(some.begin(), some.end());
  return some.front() > 0.0 ? some[neighbours / 2] : 0.0;
}

} // namespace

std::vector<HurriedBlock>
hurriedBlocks(const MachineProgram& program, double radius)
{
  const std::vector<double> speeds = speedsOf(program, radius);
  std::vector<HurriedBlock> hurried;
  for (std::size_t i = neighbours; i + neighbours < speeds.size(); ++i) {
    const double before = medianOf(speeds, i - neighbours), after = medianOf(speeds, i + 1), usual = std::max(before, after);
    if (before > 0.0 && after > 0.0 && speeds[i] > most * usual)
      hurried.push_back({i, speeds[i] / usual});
  }
  return hurried;
}

} // namespace pcl_spiral
