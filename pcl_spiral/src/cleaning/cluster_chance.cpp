// SPDX-License-Identifier: BSD-3-Clause
#include "cluster_chance.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double unlikely = 0.3; // groups that chance may make; others beside a point

/** Number of pairs of different groups whose points are nearest at 1 to 3 times \p reach, both ends counted once. */
std::size_t
pairsAround(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double farther = 3.0;
  std::vector<Eigen::Vector3f> middles;
  middles.reserve(groups.size());
  for (const StandingCluster& group : groups)
    middles.push_back(group.place.cast<float>());
  const PointBlocks blocks(middles);
  const auto squared = static_cast<float>(farther * farther * reach * reach);
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < middles.size(); ++i) {
    Box place;
    place.extend(middles[i].data());
    blocks.forBlocksNear(place, squared, [&](std::size_t block) {
      for (std::size_t k = blocks.blockBegin(block); k < blocks.blockEnd(block); ++k)
        pairs += blocks.originalIndex(k) < i && (blocks.point(k) - middles[i]).squaredNorm() <= squared;
    });
  }
  return pairs;
}

/** How many of \p count points spread evenly over \p area are expected within \p reach of one. */
double
othersWithin(std::size_t count, double reach, double area)
{
  return static_cast<double>(count) * pi * reach * reach / area;
}

} // namespace

std::size_t
leastCluster(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double shell = 8.0;      // times the area within reach
  constexpr std::size_t most = 1000; // echoes as close as this are no single ones
  const double all = static_cast<double>(groups.size());
  const double another = 2.0 * static_cast<double>(pairsAround(groups, reach)) / shell / std::max(1.0, all); // within reach of an echo
  double expected = all * another;
  std::size_t least = 2;
  for (; expected >= unlikely && least < most; ++least)
    expected *= std::min(another, 1.0);
  return least;
}

bool
isRare(std::size_t count, double reach, double area)
{
  return othersWithin(count, reach, area) < unlikely;
}

std::size_t
leastSpread(std::size_t count, double reach, double area)
{
  const double another = othersWithin(count, reach, area);
  if (another >= 1.0)
    return count + 1;
  double expected = static_cast<double>(count) * another;
  std::size_t least = 2;
  for (; expected >= unlikely; ++least)
    expected *= another;
  return least;
}

} // namespace pcl_spiral
