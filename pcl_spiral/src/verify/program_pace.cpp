// SPDX-License-Identifier: BSD-3-Clause
#include "verify/program_pace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t neighbours = 5;
constexpr double most = 1.4;
constexpr double near_limit = 0.4; // of the largest rate of a rotary axis in the program: its rate may set the time of the block

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

/** The larger of the rates of the two rotary axes on each block, each in its largest rate in the program; 0 on blocks that do not cut. */
std::vector<double>
ratesOf(const MachineProgram& program)
{
  const std::vector<ProgramBlock>& blocks = program.blocks;
  std::vector<std::array<double, 2>> rates(blocks.size(), {0.0, 0.0});
  std::array<double, 2> largest{0.0, 0.0};
  for (std::size_t i = 1; i < blocks.size(); ++i)
    if (blocks[i].section == BlockSection::Cut && blocks[i].minutes > 0.0) {
      rates[i] = {std::abs(blocks[i].angles.first - blocks[i - 1].angles.first) / blocks[i].minutes,
                  std::abs(blocks[i].angles.second - blocks[i - 1].angles.second) / blocks[i].minutes};
      for (int axis = 0; axis < 2; ++axis)
        largest[axis] = std::max(largest[axis], rates[i][axis]);
    }
  std::vector<double> shares(blocks.size(), 0.0);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    for (int axis = 0; axis < 2; ++axis)
      if (largest[axis] > 0.0)
        shares[i] = std::max(shares[i], rates[i][axis] / largest[axis]);
  return shares;
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
  std::vector<double> ways = speeds;
  for (std::size_t i = 0; i < ways.size(); ++i)
    ways[i] *= program.blocks[i].minutes;
  const std::vector<double> rates = ratesOf(program);
  std::vector<HurriedBlock> hurried;
  for (std::size_t i = neighbours; i + neighbours < speeds.size(); ++i) {
    const double before = medianOf(speeds, i - neighbours), after = medianOf(speeds, i + 1), usual = std::max(before, after);
    if (!(before > 0.0 && after > 0.0 && speeds[i] > most * usual))
      continue;
    const auto begin = rates.begin() + static_cast<std::ptrdiff_t>(i - neighbours);
    const bool at_limit = *std::max_element(begin, begin + 2 * neighbours + 1) > near_limit;
    if (!at_limit || ways[i] > most * std::max(medianOf(ways, i - neighbours), medianOf(ways, i + 1)))
      hurried.push_back({i, speeds[i] / usual});
  }
  return hurried;
}

} // namespace pcl_spiral
