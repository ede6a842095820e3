// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/reach_map.h>

#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/surface/impl/ball_reach.h>

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double largest_ball = 4.0; // tool radii

/** Adds the points of the surface of \p plan. */
void
addSurface(const SpiralPlan& plan, const SpiralSettings& settings, ReachMap& map)
{
  if (!plan.surface)
    throw std::invalid_argument("reachMap: the plan has no surface; call setKeepSurface of the planner");
  const Surface& surface = *plan.surface;
  const std::size_t first = map.radii.size();
  map.radii.resize(first + surface.size(), static_cast<float>(map.largest));
  const double tolerance = reachTolerance(surface.fit(), reach_share * settings.chord_error);
  for (const double radius : {map.largest, settings.tool_radius}) { // grooves of a few spacings are found by balls not much larger
    const BallReach reach(surface.graph(), surface.fit(), radius, tolerance);
    for (const UnreachedPoint& point : reach.unreached())
      map.radii[first + point.index] = std::min(map.radii[first + point.index], point.reach);
  }
  for (std::size_t i = 0; i < surface.size(); ++i)
    map.places.push_back(surface.position(i));
}

} // namespace

ReachMap
reachMap(const SpiralPlan& plan)
{
  ReachMap map;
  map.largest = largest_ball * plan.settings.tool_radius;
  for (const SpiralPlan& region : plan.regions)
    addSurface(region, plan.settings, map);
  if (plan.regions.empty())
    addSurface(plan, plan.settings, map);
  return map;
}

} // namespace pcl_spiral
