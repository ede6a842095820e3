// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_places.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include "common/stoppable_loop.h"
#include "given_path.h"
#include "path_feet.h"
#include "tight_ride.h"
#include "turn_spacing.h"

#include "core/parallel_resize.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/spiral/impl/path_reversals.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double gap_in_spacings = 2.7; // one in 10^9 random points lies this far from the next
constexpr double slack = 1.05;          // steps stretch a little when they are projected onto the surface
constexpr double stretched = 2.0;       // on rough surfaces they stretch more, and are halved again and again
constexpr int most_halvings = 3;

bool
isOverGap(const SurfaceFoot& foot, const Surface& surface)
{
  return isOverGap(surface, foot.position, foot.nearest, foot.nearest_distance);
}

/** Steps that projection stretched beyond the longest step get a point in their middle. Steps of more than twice that are jumps:
 *  checkPath refuses them, and steps that stay as long when halved. \return whether there were any. */
bool
halveStretchedSteps(const Surface& surface, double longest, SpiralPath& path)
{
  const auto isStretched = [&](std::size_t i) {
    const double step = (path.contacts[i] - path.contacts[i - 1]).norm();
    return step > longest && step <= stretched * longest && !beginsPass(path.passes, i);
  };
  std::size_t first = path.contacts.size();
#pragma omp parallel for schedule(static) reduction(min : first)
  for (std::size_t i = 1; i < path.contacts.size(); ++i)
    if (isStretched(i))
      first = std::min(first, i);
  std::vector<std::size_t> ends; // of the steps
  std::vector<Eigen::Vector3d> queries;
  for (std::size_t i = first; i < path.contacts.size(); ++i)
    if (isStretched(i)) {
      ends.push_back(i);
      queries.push_back(0.5 * (path.contacts[i] + path.contacts[i - 1]));
    }
  if (ends.empty())
    return false;
  std::vector<SurfaceFoot> feet;
  pathFeet(surface, queries, feet);
  SpiralPath halved;
  const auto add = [&halved](const Eigen::Vector3d& contact, const Eigen::Vector3d& normal, float turn, bool over_gap) {
    halved.contacts.push_back(contact);
    halved.normals.push_back(normal);
    halved.turns.push_back(turn);
    halved.over_gap.push_back(over_gap);
  };
  std::size_t next = 0;
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    if (next < ends.size() && ends[next] == i) {
      if (feet[next].valid)
        add(feet[next].position, feet[next].normal, 0.5f * (path.turns[i - 1] + path.turns[i]), isOverGap(feet[next], surface));
      ++next;
    }
    if (beginsPass(path.passes, i))
      halved.passes.push_back(halved.contacts.size());
    add(path.contacts[i], path.normals[i], path.turns[i], path.over_gap[i] != 0);
  }
  path = std::move(halved);
  return true;
}

} // namespace

std::vector<double>
cutLengths(const SpiralPath& path)
{
  std::vector<double> lengths(path.contacts.size(), 0.0);
  const auto count = static_cast<std::int64_t>(lengths.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 1; i < count; ++i)
    lengths[i] = beginsPass(path.passes, i) ? 0.0 : (path.contacts[i] - path.contacts[i - 1]).norm();
  std::partial_sum(lengths.begin(), lengths.end(), lengths.begin());
  return lengths;
}

bool
isOverGap(const Surface& surface, const Eigen::Vector3d& place, std::uint32_t nearest, double distance)
{
  return distance > gap_in_spacings * surface.graph().spacing(nearest) || surface.isGuessed(nearest) ||
         surface.voids().contains(place, nearest);
}

Status
measureGaps(const SpiralPath& path, const SpiralSettings& settings, GapReport& figures)
{
  figures = GapReport();
  const auto first = std::find_if(path.over_gap.begin(), path.over_gap.end(), [](std::uint8_t over) { return over != 0; });
  for (auto i = static_cast<std::size_t>(first - path.over_gap.begin()); i < path.contacts.size(); ++i) {
    figures.points += path.over_gap[i];
    if (i > 0 && (path.over_gap[i - 1] || path.over_gap[i]))
      figures.length += path.arc_lengths[i] - path.arc_lengths[i - 1];
    if (path.over_gap[i] && settings.gaps == GapHandling::Refuse && settings.rim_overhang <= 0.0) // beyond the rim there is none
      return {StatusCode::InvalidInput, Diagnostic("the {scan} has a gap at ", Place(path.contacts[i]),
                                                   ": no point of the {scan} lies near the path there; {scan it again}, or allow gaps to "
                                                   "be bridged ({setGapHandling})")};
  }
  return Status::success();
}

namespace {

/** \p known: feet that need not be found again; null: none. */
Status
putOnSurface(const std::vector<SpiralPoint>& curve, const CurveFeet* known, const Surface& surface, const SpiralSettings& settings,
             double longest_step, const ProgressCallback& progress, SpiralPath& path, GapReport& figures, const BallReach* reach)
{
  if (const Status status = checkGiven(curve.size(), "the curve"); !status.ok())
    return status;
  TightPlaces tight(settings.tool_radius);
  resizeInParallel(path.contacts, curve.size());
  resizeInParallel(path.normals, curve.size());
  path.turns.resize(curve.size());
  path.over_gap.resize(curve.size());
  path.passes.clear();
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].begins_pass)
      path.passes.push_back(i);
  const bool refuses_tight = settings.tight == TightHandling::Refuse; // told by the curvature of all feet
  const auto footOf = [&](std::size_t i) { return known && !refuses_tight ? known->find(i) : nullptr; };
  const auto set = [&](std::size_t i, const auto& foot) {
    path.contacts[i] = foot.position;
    path.normals[i] = foot.normal;
    path.over_gap[i] = isOverGap(surface, foot.position, foot.nearest, foot.nearest_distance);
    path.turns[i] = static_cast<float>(curve[i].turn);
  };
  std::vector<std::size_t> asked;
  Polyline queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < curve.size(); begin += report_chunk) {
    const std::size_t end = std::min(curve.size(), begin + report_chunk);
    asked.clear();
    for (std::size_t i = begin; i < end; ++i)
      if (!footOf(i))
        asked.push_back(i);
    const auto count = static_cast<std::int64_t>(asked.size());
    queries.resize(asked.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t k = 0; k < count; ++k)
      queries[k] = curve[asked[k]].position;
#pragma omp parallel for schedule(static)
    for (auto i = static_cast<std::int64_t>(begin); i < static_cast<std::int64_t>(end); ++i)
      if (const CurveFoot* const foot = footOf(i))
        set(i, *foot);
    pathFeet(surface, queries, feet);
    std::int64_t first_bad = count;
#pragma omp parallel for schedule(static) reduction(min : first_bad)
    for (std::int64_t k = 0; k < count; ++k) {
      if (!feet[k].valid)
        first_bad = std::min(first_bad, k);
      set(asked[k], feet[k]);
    }
    if (first_bad < count) {
      const SpiralPoint& off = curve[asked[first_bad]];
      return {StatusCode::Failed,
              Diagnostic("the path leaves the {scanned surface} at ", Place(off.position), " in turn ", off.turn,
                         ": the {scan} has a gap or a ragged rim there; {scan it again, more densely}, or cut the ragged part away")};
    }
    if (refuses_tight)
      for (const SurfaceFoot& foot : feet)
        tight.add(foot);
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(curve.size()), "projection"))
      return {StatusCode::Cancelled, "cancelled"};
  }
  if (!tight.empty())
    return tight.refusal("path points", &surface);
  for (int round = 0; round < most_halvings && halveStretchedSteps(surface, longest_step, path); ++round)
    ;
  const std::optional<HeightGrid>& heights = surface.settings().heights;
  if (settings.tight == TightHandling::Ride && !(heights && heights->isReachedBy(settings.tool_radius)))
    if (const Status status = rideTightPlaces(surface, reach, settings, longest_step, path); !status.ok())
      return status;
  path.arc_lengths = cutLengths(path);
  return measureGaps(path, settings, figures);
}

Status
jumpAt(const SpiralPath& path, std::size_t i, double longest_step)
{
  const Polyline& feet = path.onSurface();
  return {StatusCode::Failed,
          Diagnostic("the path jumps by ", (feet[i] - feet[i - 1]).norm(), " {mm} at ", Place(path.contacts[i]), " in turn ", path.turns[i],
                     ", more than the longest step of ", longest_step, " {mm}, while the normal turns by ",
                     std::acos(std::clamp(path.normals[i].dot(path.normals[i - 1]), -1.0, 1.0)) * 180.0 / pi,
                     " {degrees}: the surface folds there, or is too rough or too sparse; leave the place out ({setCrop}, {addKeepOut}), "
                     "or {scan it again, more densely}")};
}

} // namespace

Status
putOnSurface(const std::vector<SpiralPoint>& curve, const Surface& surface, const SpiralSettings& settings, double longest_step,
             const ProgressCallback& progress, SpiralPath& path, GapReport& figures, const BallReach* reach)
{
  return putOnSurface(curve, nullptr, surface, settings, longest_step, progress, path, figures, reach);
}

Status
putOnSurface(const SpiralTurns& turns, const Surface& surface, const SpiralSettings& settings, const ProgressCallback& progress,
             SpiralPath& path, GapReport& figures, const BallReach* reach)
{
  return putOnSurface(turns.curve, &turns.feet, surface, settings, turns.largest_allowed_step, progress, path, figures, reach);
}

Status
checkPath(const SpiralPath& path, const SpiralSettings& settings, double longest_step, const ProgressCallback& progress,
          ToolpathReport& figures, bool own_curve)
{
  figures = ToolpathReport();
  if (const Status status = checkGiven(path.contacts.size(), "the path"); !status.ok())
    return status;
  const Polyline& feet = path.onSurface();
  double largest = 0.0;
  std::size_t jump = feet.size();
#pragma omp parallel for schedule(static) reduction(max : largest) reduction(min : jump)
  for (std::size_t i = 1; i < path.contacts.size(); ++i) {
    if (beginsPass(path.passes, i))
      continue;
    largest = std::max(largest, (path.contacts[i] - path.contacts[i - 1]).norm());
    if (!((feet[i] - feet[i - 1]).norm() <= slack * longest_step))
      jump = std::min(jump, i);
  }
  figures.largest_gap = largest;
  if (jump < feet.size())
    return jumpAt(path, jump, longest_step);
  figures.turns = static_cast<std::size_t>(std::lround(std::abs(path.turns.back() - path.turns.front())));
  figures.points = path.contacts.size();
  figures.length = path.arc_lengths.back();
  // Each turn goes once round, so turns that are not in order cross somewhere.
  bool cancelled = false;
  const auto go_on = [&](double share) {
    cancelled = progress && !progress(share, "crossings");
    return !cancelled;
  };
  std::optional<std::size_t> crossing;
  measureTurns(path, settings, go_on, figures, crossing);
  if (cancelled)
    return {StatusCode::Cancelled, "cancelled"};
  if (crossing)
    return {StatusCode::Failed,
            Diagnostic("the path crosses itself at ", Place(path.contacts[*crossing]), " in turn ", path.turns[*crossing],
                       own_curve ? Diagnostic(": change the curve there; its passes must not cross either")
                       : settings.method == SpiralMethod::ConstantScallop
                           ? Diagnostic(": if the {scan} holds more than the part, such as the table below it, crop it to the part "
                                        "({setCrop}); else choose another scallop height ({setScallopHeight}) or the other sense "
                                        "({setSense})")
                           : ": the radial lines there are not in order; " + constantScallopRemedy(settings))};
  return checkReversals(figures.reversals, settings);
}

} // namespace pcl_spiral
