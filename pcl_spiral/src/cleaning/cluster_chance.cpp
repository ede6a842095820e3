// SPDX-License-Identifier: BSD-3-Clause
#include "cluster_chance.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double unlikely = 0.3;    // groups that chance may make
constexpr double rare_others = 0.5; // beside an echo: chance then links it with 1 / (1 - 0.5) - 1 = 1 in all, in the mean

/** For each group the number of others whose points are nearest at 1 to 3 times \p reach. */
std::vector<std::size_t>
othersAround(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double farther = 3.0;
  std::vector<Eigen::Vector3f> middles;
  middles.reserve(groups.size());
  for (const StandingCluster& group : groups)
    middles.push_back(group.place.cast<float>());
  const PointBlocks blocks(middles);
  const auto squared = static_cast<float>(farther * farther * reach * reach);
  std::vector<std::size_t> others(middles.size(), 0);
  for (std::uint32_t i = 0; i < middles.size(); ++i) {
    Box place;
    place.extend(middles[i].data());
    blocks.forBlocksNear(place, squared, [&](std::size_t block) {
      for (std::size_t k = blocks.blockBegin(block); k < blocks.blockEnd(block); ++k)
        others[i] += blocks.originalIndex(k) != i && (blocks.point(k) - middles[i]).squaredNorm() <= squared;
    });
  }
  return others;
}

/** Mean of \p counts, at most ln 2 above the median. */
double
usualCount(std::vector<std::size_t> counts)
{
  if (counts.empty())
    return 0.0;
  const double mean =
      static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0})) / static_cast<double>(counts.size());
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return std::min(mean, static_cast<double>(*middle) + std::log(2.0));
}

/** Number of points from which on fewer than 0.3 groups are expected of \p count points with \p another one beside each, up to \p most. */
std::size_t
leastExpected(std::size_t count, double another, std::size_t most)
{
  double expected = static_cast<double>(count) * another;
  std::size_t least = 2;
  for (; expected >= unlikely && least < most; ++least)
    expected *= std::min(another, 1.0);
  return least;
}

} // namespace

std::size_t
leastCluster(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double shell = 8.0;      // times the area within reach
  constexpr std::size_t most = 1000; // echoes as close as this are no single ones
  return leastExpected(groups.size(), usualCount(othersAround(groups, reach)) / shell, most);
}

double
EchoSpread::othersWithin(double reach) const
{
  const double disc = pi * reach * reach, ball = 4.0 / 3.0 * pi * reach * reach * reach;
  return static_cast<double>(count) / area * (depth > 0.0 ? std::min(disc, ball / depth) : disc);
}

bool
EchoSpread::isRare(double reach) const
{
  return othersWithin(reach) < rare_others;
}

double
EchoSpread::rareReach() const
{
  const double over = rare_others * area / std::max(1.0, static_cast<double>(count)); // mm^2
  return std::max(std::sqrt(over / pi), std::cbrt(0.75 * over * depth / pi));
}

std::size_t
EchoSpread::leastGroup(double reach) const
{
  return leastExpected(count, othersWithin(reach), count + 1);
}

double
echoDepth(std::vector<double> heights)
{
  std::sort(heights.begin(), heights.end());
  const std::size_t half = (heights.size() + 1) / 2;
  double shortest = heights.empty() ? 0.0 : heights.back() - heights.front();
  for (std::size_t i = 0; i + half < heights.size(); ++i)
    shortest = std::min(shortest, heights[i + half] - heights[i]);
  return 2.0 * shortest;
}

} // namespace pcl_spiral
