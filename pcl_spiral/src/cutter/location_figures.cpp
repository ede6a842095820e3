// SPDX-License-Identifier: BSD-3-Clause
#include "location_ground.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

#include <cmath>

namespace pcl_spiral {

LocationReport
CutterLocationEngine::figures(const ToolLocations& locations) const
{
  LocationReport f;
  for (std::size_t i = 0; i < locations.size(); ++i) {
    const ToolLocation& location = locations[i];
    ++f.states[static_cast<std::size_t>(location.state)];
    if (location.state == LocationState::NoCloud)
      continue;
    ++f.bases[static_cast<std::size_t>(location.basis)];
    if (location.over_rim) {
      f.least_rim_clearance = f.over_rim == 0 ? location.rim_clearance : std::min(f.least_rim_clearance, location.rim_clearance);
      ++f.over_rim;
    }
    f.retilted += location.retilt > 0.0;
    f.largest_retilt = std::max(f.largest_retilt, location.retilt);
    f.collisions += location.collision.found();
    if (location.under_scan && f.under_scan++ == 0)
      f.first_under_scan = i;
    if (location.collision.depth > f.deepest_collision) {
      f.deepest_collision = location.collision.depth;
      f.most_collided = i;
    }
    if (location.lift > f.largest_lift) {
      f.largest_lift = location.lift;
      f.most_lifted = i;
    }
    if (location.basis == LocationBasis::FittedSurface)
      f.largest_gap = std::max(f.largest_gap, location.gap);
    else if (location.basis != LocationBasis::AskedContact && std::isfinite(location.gap_bound))
      f.largest_gap_bound = std::max(f.largest_gap_bound, location.gap_bound);
    else if (location.basis != LocationBasis::AskedContact)
      ++f.unbounded;
  }
  const auto warn = [&](std::size_t count, const Diagnostic& what) {
    if (count > 0)
      f.warnings.push_back(Diagnostic(count, " of ", locations.size(), " locations ", what));
  };
  warn(f.count(LocationState::NoCloud),
       Diagnostic("have no ", ground_->item(), " of the ", ground_->name(), " under the cutter: they have no height"));
  constexpr double touched = 1e-3; // mm
  warn(f.over_rim, Diagnostic("are partly beyond the rim of the ", ground_->name(), " or over a gap in it, ",
                              f.least_rim_clearance < touched ? Diagnostic("at its height")
                                                              : Diagnostic("at least ", f.least_rim_clearance, " {mm} above it"),
                              ": the part may be higher there, which is not known"));
  warn(f.unbounded, "rest on single points, with no limit on how far the cutter sinks between them");
  warn(f.count(LocationBasis::PointsAndBound), Diagnostic("are raised by up to ", f.largest_gap_bound,
                                                          " {mm} above single points, the most that the cutter could "
                                                          "sink between them: there was no reliable fitted surface"));
  warn(f.count(LocationState::Unreachable), "have a given contact that overhangs the cutter's flank");
  if (f.collisions > 0) {
    const HolderCollision& worst = locations[f.most_collided].collision;
    warn(f.collisions, Diagnostic("have a collision of the ", worst.part == ToolPart::Holder ? "holder" : "cutter", " with the ",
                                  ground_->name(), ", at most ", worst.depth, " {mm} deep, clearance included: ",
                                  nameOf(worst, options_.holder), " of location ", f.most_collided, " at ", Place(worst.place),
                                  "; lengthen the tool, lean the axis away, or allow it "
                                  "to be tilted"));
  }
  if (f.under_scan > 0)
    warn(f.under_scan,
         Diagnostic("are below more of the ", ground_->name(), ", above the end of the tool, which is ", options_.tool_length,
                    " {mm} long; the first is location ", f.first_under_scan, ", its tip at ", Place(locations[f.first_under_scan].tip),
                    ": what holds the tool is not checked there; add it to the holder, or raise the ceiling: the cutter is then "
                    "lifted over it"));
  ground_->describe(locations, f);
  return f;
}

Diagnostic
nameOf(const HolderCollision& collision, const std::vector<ToolSegment>& holder)
{
  if (collision.part == ToolPart::Cutter)
    return "the cutter";
  if (collision.part == ToolPart::Shank)
    return "a shank as wide as the cutter";
  const auto segment = static_cast<std::size_t>(collision.segment);
  const std::string& name = holder.at(segment).name;
  return name.empty() ? Diagnostic("segment ", segment + 1, " of the holder") : Diagnostic(name);
}

const char*
nameOf(LocationState state)
{
  switch (state) {
  case LocationState::Touching:
    return "touching";
  case LocationState::Reached:
    return "reached";
  case LocationState::Lifted:
    return "lifted";
  case LocationState::Clear:
    return "clear";
  case LocationState::Unreachable:
    return "unreachable";
  case LocationState::NoCloud:
    return "no cloud";
  }
  return "";
}

const char*
nameOf(LocationBasis basis)
{
  switch (basis) {
  case LocationBasis::FittedSurface:
    return "fitted surface";
  case LocationBasis::PointsAndBound:
    return "points and bound";
  case LocationBasis::Points:
    return "points";
  case LocationBasis::AskedContact:
    return "asked contact";
  }
  return "";
}

} // namespace pcl_spiral
