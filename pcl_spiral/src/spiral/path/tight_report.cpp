// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_report.h>

#include "place_groups.h"

#include "cleaning/standing_clusters.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/spiral/impl/path_reversals.h>
#include <pcl_spiral/spiral/impl/tight_places.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl_spiral {
namespace {

constexpr double least_reached = 0.5; // of the points
constexpr double well_reached = 0.9;  // of the points
constexpr double surely = 0.95;       // of the largest radius there
constexpr double edge_share = 0.5;    // of the spacing: the edge of a thing lies between its last points and those beside it

/** The widest spacing of points at the edge of a thing that the ball rides over: of the surface, or of the points of the thing if they
 *  are farther apart, mm. */
double
edgeSpacing(const Surface& surface)
{
  double widest = surface.spacing();
  for (const StandingCluster& cluster : surface.clusters())
    widest = std::max(widest, cluster.spacing);
  return widest;
}

/** Adds the places where more than the scallop height stays: of \p points, their indices \p of in reach.unreached() and \p heights. */
void
addPlaces(const BallReach& reach, const Polyline& points, const std::vector<std::size_t>& of, const std::vector<float>& heights,
          std::vector<TightPlace>& places)
{
  std::size_t count = 0;
  const std::size_t first = places.size();
  const std::vector<std::size_t> groups = placeGroups(points, 0.5 * reach.radius(), count);
  places.resize(first + count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const UnreachedPoint& point = reach.unreached()[of[i]];
    TightPlace& place = places[first + groups[i]];
    place.area += point.area;
    place.under_cluster = point.covered;
    place.radius = place.radius > 0.0 ? std::min<double>(place.radius, point.reach) : point.reach;
    if (heights[of[i]] > place.height) {
      place.height = heights[of[i]];
      place.place = points[i];
    }
  }
}

/** Places where more than the scallop height stays, the highest stock first. */
std::vector<TightPlace>
placesOf(const BallReach& reach, double scallop_height)
{
  const std::vector<float> heights = reach.heightsLeft();
  std::vector<TightPlace> places;
  for (const bool covered : {false, true}) {
    Polyline points;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < heights.size(); ++k)
      if (reach.unreached()[k].covered == covered && heights[k] > scallop_height + reach.tolerance()) {
        points.push_back(reach.position(reach.unreached()[k].index));
        kept.push_back(k);
      }
    addPlaces(reach, points, kept, heights, places);
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

/** "1 place: ... up to 2 mm, the most at (1, 2, 3), and more than the scallop height on 4 mm2 in all; no scallop ..." */
Diagnostic
stockText(const std::vector<TightPlace>& places)
{
  double area = 0.0;
  for (const TightPlace& place : places)
    area += place.area;
  const TightPlace& highest = places.front();
  return Diagnostic(places.size(), places.size() == 1 ? " place" : " places", ": it stays above the surface there and leaves up to ",
                    highest.height, " {mm}, the most at ", Place(highest.place), ", and more than the scallop height on ", area,
                    " {mm2} in all; no scallop height is promised there");
}

/** Which ball reaches everything; {setTightHandling(TightHandling::Refuse)} does not refuse it. */
Diagnostic
fittingText(const SpiralReport& report)
{
  if (const std::optional<double> radius = fittingBall(report.fitting_radius, report.spacing))
    return Diagnostic("a ball of radius ", *radius, " {mm} or less reaches everything");
  return Diagnostic("no ball is named that reaches everything, as an inner edge, tighter than the ", report.spacing,
                    " {mm} between the points, has no radius {on the scan}");
}

Diagnostic
hollowWarning(const std::vector<TightPlace>& places, const SpiralReport& report)
{
  return Diagnostic("the ball does not reach ", stockText(places), ": ", fittingText(report),
                    " ({setToolRadius}); {BallReach} maps the largest ball at each point, and "
                    "{setTightHandling(TightHandling::Refuse)} refuses such "
                    "parts");
}

Diagnostic
missedWarning(const MissedPoints& missed)
{
  return Diagnostic(
      missed.count, missed.count == 1 ? " point of the {scan} stands" : " points of the {scan} stand", " up to ", missed.height,
      " {mm} over the fitted surface, the most at ", Place(missed.place),
      ": unless these are false echoes, an edge or a step there has too few points, and the path cuts into it, deeper between the points; "
      "{scan more densely} there, "
      "keep out of it ({addKeepOut}), or, if it is the side of a part that lies on a table, crop the {scan} to the part ({setCrop})");
}

Diagnostic
clusterWarning(const std::vector<TightPlace>& places)
{
  return Diagnostic("the ball rides over clusters of points at ", stockText(places),
                    ", nor within a step-over of them ({setClusterHandling(ClusterHandling::Ride)}); it stays half of their spacing away "
                    "from the points: edges farther beyond them are not known");
}

/** Counts the places where the ball turns back, and warns of them. */
void
reportBallReversals(const SpiralPath& path, const SpiralSettings& settings, SpiralReport& report)
{
  const PathReversals reversals = ballReversals(path, settings.tool_radius);
  report.reversals += reversals.count;
  if (reversals.count > 0)
    report.warnings.push_back(Diagnostic(
        "the ball turns back at ", reversals.count, reversals.count == 1 ? " place" : " places", " (", reversals.lifted,
        " of them where it is lifted), by up to ", reversals.angle, " {degrees} at ", Place(reversals.place), " in turn ", reversals.turn,
        ", while its path over the surface runs on: the surface there is as hollow as the ball or more; ",
        report.fitting_radius < settings.tool_radius ? fittingText(report) : Diagnostic("a smaller ball runs on"), " ({setToolRadius})"));
}

} // namespace

Status
checkRidden(const Surface& surface, const SpiralSettings& settings)
{
  if (surface.riddenPoints().empty())
    return Status::success();
  if (settings.method == SpiralMethod::Published)
    return {StatusCode::InvalidArgument,
            "the published method does not ride over the clusters on the {scan} ({setClusterHandling(ClusterHandling::Ride)}): "
            "choose another method ({setMethod})"};
  if (settings.tight == TightHandling::Refuse)
    return {StatusCode::InvalidArgument,
            "the ball must be lifted to ride over the clusters on the {scan} ({setClusterHandling(ClusterHandling::Ride)}), "
            "but {setTightHandling(TightHandling::Refuse)} refuses to lift it: leave one of them out"};
  return checkRideHeight(surface.clusters(), settings.tool_radius);
}

namespace {

std::unique_ptr<BallReach>
reachOf(const Surface& surface, const SpiralSettings& settings, const std::vector<SurfacePatch>& beyond, double least)
{
  const std::optional<HeightGrid>& heights = surface.settings().heights;
  if (settings.tight == TightHandling::Refuse || (heights && heights->isReachedBy(settings.tool_radius)))
    return nullptr;
  auto reach = std::make_unique<BallReach>(
      surface.graph(), surface.fit(), settings.tool_radius, reachTolerance(surface.fit(), reach_share * settings.chord_error),
      BallObstacles{surface.riddenPoints(), ride_share * settings.chord_error + edge_share * edgeSpacing(surface)}, beyond, least);
  reach->addMissed(surface.fit(), surface.isolatedPoints(), surface.spacing());
  return reach;
}

Status
checkReach(const BallReach* reach)
{
  if (!reach || reach->unreached().empty())
    return Status::success();
  std::vector<UnreachedPoint> tight;
  std::copy_if(reach->unreached().begin(), reach->unreached().end(), std::back_inserter(tight),
               [reach](const UnreachedPoint& point) { return point.reach < static_cast<float>(reach->radius()); });
  const auto all = static_cast<double>(reach->looked());
  const double reached = 1.0 - static_cast<double>(tight.size()) / all;
  if (reached >= least_reached)
    return Status::success();
  std::sort(tight.begin(), tight.end(),
            [](const UnreachedPoint& a, const UnreachedPoint& b) { return a.reach != b.reach ? a.reach < b.reach : a.index < b.index; });
  const auto missed = static_cast<std::size_t>((1.0 - well_reached) * all);
  return {StatusCode::InvalidArgument,
          Diagnostic("a ball of radius ", reach->radius(), " {mm} reaches only ", 100.0 * reached, " % of the surface; at ",
                     Place(reach->position(tight.front().index)), " only one of ", tight.front().reach, " {mm} fits. Use a ball of radius ",
                     surely * tight[missed].reach, " {mm} or less, which reaches nine tenths of it ({setToolRadius})")};
}

} // namespace

std::unique_ptr<BallReach>
makeReach(const Surface& surface, const SpiralSettings& settings, const std::vector<SurfacePatch>& beyond)
{
  return reachOf(surface, settings, beyond, 0.0);
}

Status
makeReach(const Surface& surface, const SpiralSettings& settings, const std::vector<SurfacePatch>& beyond,
          std::unique_ptr<BallReach>& reach)
{
  reach = reachOf(surface, settings, beyond, least_reached);
  Status status = checkReach(reach.get());
  if (!status.ok())
    reach.reset();
  return status;
}

void
reportTight(const BallReach& reach, const SpiralPath& path, const SpiralSettings& settings, SpiralReport& report)
{
  report.fitting_radius = reach.radius();
  for (const UnreachedPoint& point : reach.unreached())
    report.fitting_radius = std::min<double>(report.fitting_radius, point.reach);
  measureLifts(path, reach.tolerance(), report);
  report.missed = reach.missed();
  if (report.missed.count > 0)
    report.warnings.push_back(missedWarning(report.missed));
  reportBallReversals(path, settings, report);
  report.tight_places = placesOf(reach, settings.scallop_height);
  for (const bool under_cluster : {false, true}) {
    std::vector<TightPlace> places;
    std::copy_if(report.tight_places.begin(), report.tight_places.end(), std::back_inserter(places),
                 [&](const TightPlace& place) { return place.under_cluster == under_cluster; });
    if (!places.empty())
      report.warnings.push_back(under_cluster ? clusterWarning(places) : hollowWarning(places, report));
  }
}

} // namespace pcl_spiral
