// SPDX-License-Identifier: BSD-3-Clause
#include "planning/joined_report.h"

#include "planning/joined_plan.h"
#include "planning/plan_regions.h"

#include <algorithm>
#include <initializer_list>

namespace pcl_spiral {
namespace {

template <typename Item>
void
append(const std::vector<Item>& items, std::vector<Item>& all)
{
  all.insert(all.end(), items.begin(), items.end());
}

void
addCounts(const SpiralReport& one, SpiralReport& all)
{
  all.used_points += one.used_points;
  all.passes += one.passes;
  all.boundaries += one.boundaries;
  all.unsettled_lines += one.unsettled_lines;
  all.scallop_loops += one.scallop_loops;
  all.chain_loops += one.chain_loops;
  all.bridges += one.bridges;
  all.fingers += one.fingers;
  all.turns += one.turns;
  all.gap_points += one.gap_points;
  all.reversals += one.reversals;
  all.deviating_points += one.deviating_points;
  for (const auto count : {&SpiralReport::input_points, &SpiralReport::nonfinite_points, &SpiralReport::duplicate_points,
                           &SpiralReport::surplus_points, &SpiralReport::outlier_points})
    all.*count = std::max(all.*count, one.*count); // of the scan, which they share
  all.centre_settled = all.centre_settled && one.centre_settled;
  all.harmonic_lines = all.harmonic_lines || one.harmonic_lines;
}

void
addLengths(const SpiralReport& one, SpiralReport& all)
{
  all.reversed_share =
      (all.reversed_share * all.path_length + one.reversed_share * one.path_length) / std::max(all.path_length + one.path_length, 1e-9);
  using Number = double SpiralReport::*;
  for (const Number length :
       std::initializer_list<Number>{&SpiralReport::path_length, &SpiralReport::lift_length, &SpiralReport::gap_length,
                                     &SpiralReport::lifted_length, &SpiralReport::foreseen_radial, &SpiralReport::foreseen_scallop})
    all.*length += one.*length;
  for (const Number most : std::initializer_list<Number>{
           &SpiralReport::spacing, &SpiralReport::noise, &SpiralReport::largest_unsettled, &SpiralReport::line_error,
           &SpiralReport::line_tolerance, &SpiralReport::largest_step_over, &SpiralReport::largest_lift, &SpiralReport::corner_ridge,
           &SpiralReport::largest_allowed_step, &SpiralReport::largest_gap, &SpiralReport::largest_axis_change,
           &SpiralReport::largest_axis_rate, &SpiralReport::largest_axis_lean, &SpiralReport::largest_axis_deviation})
    all.*most = std::max(all.*most, one.*most);
}

void
addPlaces(const SpiralReport& one, SpiralReport& all)
{
  append(one.loops, all.loops);
  append(one.holes, all.holes);
  append(one.radial_lines, all.radial_lines);
  append(one.scallop_lines, all.scallop_lines);
  append(one.finger_axes, all.finger_axes);
  append(one.tight_places, all.tight_places);
  all.missed.count += one.missed.count;
  all.missed.noise = std::max(all.missed.noise, one.missed.noise);
  all.missed.least = std::max(all.missed.least, one.missed.least);
  if (one.missed.height > all.missed.height) {
    all.missed.height = one.missed.height;
    all.missed.place = one.missed.place;
  }
  if (one.smallest_step_over < all.smallest_step_over) {
    all.smallest_step_over = one.smallest_step_over;
    all.closest_place = one.closest_place;
  }
  if (one.turn_radius > 0.0 && (all.turn_radius == 0.0 || one.turn_radius < all.turn_radius)) {
    all.turn_radius = one.turn_radius;
    all.sharpest_place = one.sharpest_place;
  }
  all.fitting_radius = std::min(all.fitting_radius, one.fitting_radius);
}

} // namespace

SpiralReport
joinedReport(const std::vector<SpiralPlan>& regions, const pcl::PointCloud<ToolpathPoint>& path)
{
  SpiralReport all = regions.front().report;
  all.left_out_parts = all.left_out_points = 0;
  all.warnings.clear();
  bool has_least = true;
  for (const SpiralPlan& region : regions) {
    const SpiralReport& one = region.report;
    if (&region != &regions.front()) {
      addCounts(one, all);
      addLengths(one, all);
      addPlaces(one, all);
      all.least_length += one.least_length;
      for (const StageCost& stage : one.stages)
        addStage(stage, all.stages);
    }
    has_least = has_least && one.least_length > 0.0;
    append(ofRegion(region.region, one.warnings), all.warnings);
  }
  std::stable_sort(all.tight_places.begin(), all.tight_places.end(),
                   [](const TightPlace& a, const TightPlace& b) { return a.height > b.height; });
  all.least_length = has_least ? all.least_length : 0.0;
  all.efficiency = has_least ? all.least_length / all.path_length : 0.0;
  all.path_points = path.size();
  all.pass_begins = passBegins(path);
  all.lift_length = 0.0;
  for (const std::size_t begin : all.pass_begins)
    all.lift_length += (path[begin].getVector3fMap() - path[begin - 1].getVector3fMap()).norm();
  return all;
}

} // namespace pcl_spiral
