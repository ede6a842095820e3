// SPDX-License-Identifier: BSD-3-Clause
#include "verify/program_pace.h"
#include "core/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr std::size_t neighbours = 5;
constexpr double most = 1.4;
constexpr double over_median = 1.2;
constexpr double sharp_edge = 0.17, sharp_turn = 0.5; // radians: of the normal on a block, and of the way at its ends
constexpr double near_limit = 0.4; // of the largest rate of a rotary axis in the program: its rate may set the time of the block

/** Way of the ball's centre on each block; zero on blocks that do not cut. */
std::vector<Eigen::Vector3d>
waysOf(const MachineProgram& program, double radius)
{
  const std::vector<ProgramBlock>& blocks = program.blocks;
  std::vector<Eigen::Vector3d> ways(blocks.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 1; i < blocks.size(); ++i)
    if (blocks[i].section == BlockSection::Cut && blocks[i].minutes > 0.0)
      ways[i] = blocks[i].tip + radius * blocks[i].axis - blocks[i - 1].tip - radius * blocks[i - 1].axis;
  return ways;
}

bool
turnsSharply(const Eigen::Vector3d& way, const Eigen::Vector3d& next)
{
  return way.dot(next) < std::cos(sharp_turn) * way.norm() * next.norm();
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
medianAbout(const std::vector<double>& speeds, std::size_t begin)
{
  std::vector<double> some(speeds.begin() + static_cast<std::ptrdiff_t>(begin),
                           speeds.begin() + static_cast<std::ptrdiff_t>(begin + neighbours));
  std::sort(some.begin(), some.end());
  return some.front() > 0.0 ? some[neighbours / 2] : 0.0;
}

} // namespace

std::vector<HurriedBlock>
hurriedBlocks(const MachineProgram& program, double radius, const std::vector<BlockContact>& contacts)
{
  const std::vector<Eigen::Vector3d> steps = waysOf(program, radius);
  std::vector<double> ways(steps.size(), 0.0), speeds = ways, contact_speeds = ways, cutting;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ways[i] = steps[i].norm();
    if (!(ways[i] > 0.0))
      continue;
    speeds[i] = ways[i] / program.blocks[i].minutes;
    contact_speeds[i] = contacts[i].way / program.blocks[i].minutes;
    cutting.push_back(contact_speeds[i]);
  }
  if (cutting.empty())
    return {};
  const double usual = medianOf(std::move(cutting));
  const auto exceeds = [](const std::vector<double>& values, std::size_t i) {
    return values[i] > most * std::max(medianAbout(values, i - neighbours), medianAbout(values, i + 1));
  };
  const auto isSharp = [&](std::size_t i) {
    return contacts[i].turn > sharp_edge || turnsSharply(steps[i - 1], steps[i]) || turnsSharply(steps[i], steps[i + 1]);
  };
  const std::vector<double> rates = ratesOf(program);
  std::vector<HurriedBlock> hurried;
  for (std::size_t i = neighbours; i + neighbours < speeds.size(); ++i) {
    const double before = medianAbout(speeds, i - neighbours), after = medianAbout(speeds, i + 1);
    if (!(before > 0.0 && after > 0.0 && exceeds(speeds, i) && exceeds(contact_speeds, i) && contact_speeds[i] > over_median * usual) ||
        isSharp(i))
      continue;
    const auto begin = rates.begin() + static_cast<std::ptrdiff_t>(i - neighbours);
    const bool at_limit = *std::max_element(begin, begin + 2 * neighbours + 1) > near_limit;
    if (!at_limit || exceeds(ways, i))
      hurried.push_back({i, speeds[i] / std::max(before, after)});
  }
  return hurried;
}

} // namespace pcl_spiral
