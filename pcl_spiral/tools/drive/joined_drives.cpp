// SPDX-License-Identifier: BSD-3-Clause
#include "joined_drives.h"

#include "passes/scan_surface.h"

#include "planning/joined_plan.h"

#include <algorithm>

using namespace pcl_spiral;

namespace {

RegionPoints
pointsOf(const Result& region)
{
  RegionPoints own{region.region, {}};
  for (std::size_t i = 0; region.surface && i < region.surface->size(); ++i) {
    const pcl::PointXYZ& p = (*region.scan.cloud)[region.surface->sourceIndex(i)];
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
add(const LocationFigures& one, LocationFigures& all)
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
add(const BisectionFigures& one, BisectionFigures& all)
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
  all.entering += one.entering;
  all.touching += one.touching;
  all.beside += one.beside;
  all.deepest = std::max(all.deepest, one.deepest);
  all.deepest_beside = std::max(all.deepest_beside, one.deepest_beside);
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

Result
joined(const Job& job, std::vector<Result> regions)
{
  std::vector<RegionPoints> points;
  for (const Result& region : regions)
    points.push_back(pointsOf(region));
  require(job.scan, checkApart(points));
  Result all = regions.front();
  all.region.clear();
  all.surface.reset();
  all.scan.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*all.whole_scan);
  all.warnings = ofRegion(regions.front().region, all.warnings);
  all.regions = {{regions.front().region, all.passes.size(), all.poseCount()}};
  for (std::size_t k = 1; k < regions.size(); ++k) {
    const Result& region = regions[k];
    all.regions.push_back({region.region, region.passes.size(), region.poseCount()});
    all.passes.insert(all.passes.end(), region.passes.begin(), region.passes.end());
    all.length += region.length;
    all.off_scan += region.off_scan;
    for (Diagnostic& warning : ofRegion(region.region, region.warnings))
      all.warnings.push_back(std::move(warning));
    add(region.drive, all.drive);
    add(region.locations, all.locations);
    add(region.bisection, all.bisection);
    add(region.left_out, all.left_out);
    add(region.stages, all.stages);
  }
  return all;
}
