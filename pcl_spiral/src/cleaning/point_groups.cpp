// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/impl/point_groups.h>

#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <numeric>

namespace pcl_spiral {
namespace {

/** The first point of the group of \p i, in a forest whose roots are first points. */
std::uint32_t
firstOf(std::vector<std::uint32_t>& before, std::uint32_t i)
{
  while (before[i] != i) {
    before[i] = before[before[i]];
    i = before[i];
  }
  return i;
}

} // namespace

std::vector<std::uint32_t>
pointGroups(const std::vector<Eigen::Vector3f>& points, double reach)
{
  std::vector<std::uint32_t> before(points.size());
  std::iota(before.begin(), before.end(), 0u);
  const PointBlocks blocks(points);
  const auto squared = static_cast<float>(reach * reach);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    Box place;
    place.extend(points[i].data());
    blocks.forBlocksNear(place, squared, [&](std::size_t block) {
      for (std::size_t k = blocks.blockBegin(block); k < blocks.blockEnd(block); ++k) {
        const std::uint32_t j = blocks.originalIndex(k);
        if (j >= i || (points[j] - points[i]).squaredNorm() > squared)
          continue;
        const std::uint32_t a = firstOf(before, i), b = firstOf(before, j);
        before[std::max(a, b)] = std::min(a, b);
      }
    });
  }
  std::vector<std::uint32_t> group(points.size());
  std::uint32_t groups = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t first = firstOf(before, i);
    group[i] = first == i ? groups++ : group[first];
  }
  return group;
}

} // namespace pcl_spiral
