// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_report.h>

#include "place_groups.h"

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double noise_share = 0.1;   // of the chord error: the least tolerance
constexpr double least_reached = 0.5; // of the points
constexpr double well_reached = 0.9;  // of the points
constexpr double surely = 0.95;       // of the largest radius there

/** Places where more than the scallop height stays, the highest stock first. */
std::vector<TightPlace>
placesOf(const BallReach& reach, double scallop_height)
{
  const std::vector<float> heights = reach.heightsLeft();
  Polyline points;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < heights.size(); ++k)
    if (heights[k] > scallop_height + reach.tolerance()) {
      points.push_back(reach.position(reach.unreached()[k].index));
      kept.push_back(k);
    }
  std::size_t count = 0;
  const std::vector<std::size_t> groups = placeGroups(points, 0.5 * reach.radius(), count);
  std::vector<TightPlace> places(count);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const UnreachedPoint& point = reach.unreached()[kept[i]];
    TightPlace& place = places[groups[i]];
    place.area += point.area;
    place.radius = place.radius > 0.0 ? std::min<double>(place.radius, point.reach) : point.reach;
    if (heights[kept[i]] > place.height) {
      place.height = heights[kept[i]];
      place.place = points[i];
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const TightPlace& a, const TightPlace& b) { return a.height > b.height; });
  return places;
}

void
measureLifts(const SpiralPath& path, double tolerance, SpiralReport& report)
{
  for (std::size_t i = 0; i < path.lifts.size(); ++i) {
    report.largest_lift = std::max<double>(report.largest_lift, path.lifts[i]);
    if (i > 0 && !beginsPass(path.passes, i) && std::max(path.lifts[i - 1], path.lifts[i]) > tolerance)
      report.lifted_length += path.arc_lengths[i] - path.arc_lengths[i - 1];
  }
}

} // namespace

std::unique_ptr<BallReach>
makeReach(const Surface& surface, const SpiralSettings& settings)
{
  if (settings.tight == TightHandling::Refuse)
    return nullptr;
  return std::make_unique<BallReach>(surface.graph(), surface.fit(), settings.tool_radius,
                                     reachTolerance(surface.fit(), noise_share * settings.chord_error));
}

Status
checkReach(const BallReach* reach)
{
  if (!reach || reach->unreached().empty())
    return Status::success();
  std::vector<UnreachedPoint> tight = reach->unreached();
  const auto all = static_cast<double>(reach->size());
  const double reached = 1.0 - static_cast<double>(tight.size()) / all;
  if (reached >= least_reached)
    return Status::success();
  std::sort(tight.begin(), tight.end(),
            [](const UnreachedPoint& a, const UnreachedPoint& b) { return a.reach != b.reach ? a.reach < b.reach : a.index < b.index; });
  const auto missed = static_cast<std::size_t>((1.0 - well_reached) * all);
  return {StatusCode::InvalidArgument,
          textOf("a ball of radius ", reach->radius(), " mm reaches only ", 100.0 * reached, " % of the surface; at ",
                 placeText(reach->position(tight.front().index)), " only one of ", tight.front().reach, " mm fits. Use a ball of radius ",
                 surely * tight[missed].reach, " mm or less, which reaches nine tenths of it (setToolRadius)")};
}

void
reportTight(const BallReach& reach, const SpiralPath& path, const SpiralSettings& settings, SpiralReport& report)
{
  report.fitting_radius = reach.radius();
  for (const UnreachedPoint& point : reach.unreached())
    report.fitting_radius = std::min<double>(report.fitting_radius, point.reach);
  measureLifts(path, reach.tolerance(), report);
  report.tight_places = placesOf(reach, settings.scallop_height);
  if (report.tight_places.empty())
    return;
  double area = 0.0;
  for (const TightPlace& place : report.tight_places)
    area += place.area;
  const TightPlace& highest = report.tight_places.front();
  report.warnings.push_back(textOf(
      "the ball does not reach ", report.tight_places.size(), report.tight_places.size() == 1 ? " place" : " places",
      ": it stays above the surface there and leaves up to ", highest.height, " mm, the most at ", placeText(highest.place),
      ", and more than the scallop height on ", area, " mm^2 in all; no scallop height is promised there. A ball of radius ",
      report.fitting_radius,
      " mm reaches everything (setToolRadius); BallReach maps the largest ball at each point, and setTightHandling refuses such parts"));
}

} // namespace pcl_spiral
