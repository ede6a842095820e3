// SPDX-License-Identifier: BSD-3-Clause
#include "sheet_refusal.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/impl/smoothing_remedy.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** How points lie about the surface. */
struct Lie {
  PointHeight farthest{Eigen::Vector3d::Zero(), 0.0};
  double half = 0.0;  ///< half of the points lie within this distance
  double tenth = 0.0; ///< one in ten lies farther off than this
  double above = 0.0; ///< share of those on the outer side
};

Lie
lieOf(std::vector<PointHeight> heights)
{
  Lie lie;
  if (heights.empty())
    return lie;
  std::sort(heights.begin(), heights.end(),
            [](const PointHeight& a, const PointHeight& b) { return std::abs(a.value) < std::abs(b.value); });
  lie.farthest = heights.back();
  const std::size_t far = heights.size() - 1 - heights.size() / 10;
  lie.half = std::abs(heights[heights.size() / 2].value);
  lie.tenth = std::abs(heights[far].value);
  lie.above = static_cast<double>(std::count_if(heights.begin() + static_cast<std::ptrdiff_t>(far), heights.end(),
                                                [](const PointHeight& height) { return height.value > 0.0; })) /
              static_cast<double>(heights.size() - far);
  return lie;
}

} // namespace

Status
sheetRefusal(double noise, double spacing, const std::vector<PointHeight>& heights)
{
  const Lie lie = lieOf(heights);
  return {
      StatusCode::InvalidInput,
      Diagnostic("the noise of the points about a local surface is ", noise, " {mm}, up to ", std::abs(lie.farthest.value), " {mm} at ",
                 Place(lie.farthest.place), ", and their spacing is ", spacing, " {mm}. Half of the points lie within ", lie.half,
                 " {mm} of the surface, one in ten more than ", lie.tenth, " {mm} off it, ", std::round(100.0 * lie.above),
                 " % of these above it: this is not a single sheet (a thin double wall, noise above the point spacing, or trees or "
                 "flying points over the surface), or it bends too tightly for its points (a radius under two spacings); for a wall, keep "
                 "only one side in the {cloud}; where trees or flying points are, crop the {scan} to the part; for tight bends, "
                 "{scan more densely}; for noise, ",
                 smoothingRemedy(noise, spacing))};
}

} // namespace pcl_spiral
