// SPDX-License-Identifier: BSD-3-Clause
#include "outlier_candidates.h"

#include "search/pieces.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

float
medianSize(std::vector<float> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end(), [](float a, float b) { return std::abs(a) < std::abs(b); });
  return std::abs(*middle);
}

/** \p name(i) of all points i that \p counts accepts, ascending. */
template <typename Counts, typename Name>
std::vector<std::uint32_t>
pointsThat(std::size_t points, Counts counts, Name name)
{
  std::vector<std::vector<std::uint32_t>> found(pieceCount(points));
  forPoints(points, [&](std::uint32_t i) {
    if (counts(i))
      found[i / piece_size].push_back(name(i));
  });
  std::vector<std::uint32_t> all;
  for (const auto& part : found)
    all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace

std::vector<std::uint32_t>
isolatedPoints(const PointBlocks& blocks, const StarSet& stars, const PointShapes& shapes, double far)
{
  constexpr double over_median = 8.0, over_spacing = 0.25, company = 0.5;
  const double usual = medianSize(shapes.heights);
  const auto isIsolated = [&](std::uint32_t i) {
    const double height = std::abs(shapes.heights[i]);
    if (shapes.radii[i] > far)
      return true;
    if (height < over_median * usual || height < over_spacing * shapes.spacing(i))
      return false;
    for (std::uint32_t s = stars.begin[i]; s < stars.begin[i + 1]; ++s)
      if (std::abs(shapes.heights[stars.neighbourAt(s)]) >= company * height)
        return false;
    return true;
  };
  return pointsThat(blocks.size(), isIsolated, [&](std::uint32_t i) { return blocks.originalIndex(i); });
}

std::vector<std::uint32_t>
spikeCandidates(const StarSet& stars, const PointShapes& shapes)
{
  constexpr double over_median = 6.0, over_spacing = 0.03;
  std::vector<float> off(shapes.heights.size());
  forPoints(off.size(), [&](std::uint32_t i) {
    float about = 0.0f;
    for (std::uint32_t s = stars.begin[i]; s < stars.begin[i + 1]; ++s) {
      const std::uint32_t j = stars.neighbourAt(s); // signs of normals are arbitrary
      about += shapes.normals[i].dot(shapes.normals[j]) < 0.0f ? -shapes.heights[j] : shapes.heights[j];
    }
    const auto count = static_cast<float>(stars.begin[i + 1] - stars.begin[i]);
    off[i] = shapes.heights[i] - (count > 0.0f ? about / count : 0.0f);
  });
  const double usual = medianSize(off);
  const auto isCandidate = [&](std::uint32_t i) {
    return std::abs(off[i]) > std::max(over_median * usual, over_spacing * shapes.spacing(i));
  };
  return pointsThat(off.size(), isCandidate, [](std::uint32_t i) { return i; });
}

} // namespace pcl_spiral
