// SPDX-License-Identifier: BSD-3-Clause
#include "planning/joined_passes.h"

#include "planning/joined_plan.h"
#include "planning/plan_regions.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

RegionPoints
pointsOf(const PassPlan& region)
{
  RegionPoints own{region.region, {}};
  for (std::size_t i = 0; region.surface && i < region.surface->size(); ++i) {
    const pcl::PointXYZ& p = (*region.cloud)[region.surface->sourceIndex(i)];
    own.points.push_back({p.x, p.y, p.z});
  }
  return own;
}

void
add(const DriveReport& one, DriveReport& all)
{
  all.points += one.points;
  all.rows += one.rows;
  all.links += one.links;
  all.rows_apart += one.rows_apart;
  all.facing_away += one.facing_away;
  all.step_over = std::max(all.step_over, one.step_over);
  all.smallest_step = std::min(all.smallest_step, one.smallest_step);
  all.held_share = std::min(all.held_share, one.held_share);
  all.column.reset(); // each region has its own
}

void
add(const LocationReport& one, LocationReport& all)
{
  for (std::size_t i = 0; i < location_states; ++i)
    all.states[i] += one.states[i];
  for (std::size_t i = 0; i < location_bases; ++i)
    all.bases[i] += one.bases[i];
  all.over_rim += one.over_rim;
  all.retilted += one.retilted;
  all.collisions += one.collisions;
  all.under_scan += one.under_scan;
  all.largest_retilt = std::max(all.largest_retilt, one.largest_retilt);
  all.deepest_collision = std::max(all.deepest_collision, one.deepest_collision);
  all.noise_allowance = std::max(all.noise_allowance, one.noise_allowance);
}

void
add(const BisectionReport& one, BisectionReport& all)
{
  all.inserted += one.inserted;
  all.unresolved += one.unresolved;
  all.not_judged += one.not_judged;
  if (one.largest_error > all.largest_error) {
    all.largest_error = one.largest_error;
    all.worst_place = one.worst_place;
  }
}

void
add(const LeftOutLocations& one, LeftOutLocations& all)
{
  if (all.touching == 0)
    all.first = one.first;
  if (all.beside == 0)
    all.first_beside = one.first_beside;
  all.entering += one.entering;
  all.touching += one.touching;
  all.beside += one.beside;
  all.deepest = std::max(all.deepest, one.deepest);
  all.deepest_beside = std::max(all.deepest_beside, one.deepest_beside);
  all.contacts.insert(all.contacts.end(), one.contacts.begin(), one.contacts.end());
}

void
add(const std::vector<StageCost>& stages, std::vector<StageCost>& all)
{
  for (const StageCost& stage : stages) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const StageCost& s) { return s.name == stage.name; });
    if (same == all.end())
      all.push_back(stage);
    else
      same->seconds += stage.seconds;
  }
}

} // namespace

Status
joinPasses(const std::vector<PassPlan>& regions, PassPlan& all)
{
  std::vector<RegionPoints> points;
  points.reserve(regions.size());
  for (const PassPlan& region : regions)
    points.push_back(pointsOf(region));
  if (const Status status = checkApart(points); !status.ok())
    return status;
  all = regions.front();
  all.region.clear();
  all.surface.reset();
  all.cloud = all.whole;
  all.warnings.clear();
  all.passes.clear();
  all.normals.reset();
  all.chosen = ChosenPart();
  all.chosen.keep_outs = regions.front().chosen.keep_outs;
  all.drive.warnings.clear();
  all.locations.warnings.clear();
  for (const PassPlan& region : regions) {
    all.regions.push_back({region.region, region.passes.size(), region.poseCount(), region.surface, region.side});
    all.passes.insert(all.passes.end(), region.passes.begin(), region.passes.end());
    for (const Diagnostic& warning : ofRegion(region.region, region.chosen.warnings))
      all.warnings.push_back(warning);
    for (const Diagnostic& warning : ofRegion(region.region, region.warnings))
      all.warnings.push_back(warning);
    if (&region == &regions.front())
      continue;
    all.length += region.length;
    all.tool.tolerance = std::max(all.tool.tolerance, region.tool.tolerance);
    all.off_scan += region.off_scan;
    add(region.drive, all.drive);
    add(region.locations, all.locations);
    add(region.bisection, all.bisection);
    add(region.left_out, all.left_out);
    add(region.stages, all.stages);
  }
  return Status::success();
}

} // namespace pcl_spiral
