// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/loop_linking.h>

#include "common/stoppable_loop.h"
#include "given_path.h"
#include "path_feet.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/step_over.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double step_reserve = 0.95;  // feet spread apart a little
constexpr double least_step = 1e-6;    // of the longest: where the ball hardly fits, its centre does not move and any step is allowed
constexpr double straight_share = 0.2; // of the chord error
constexpr double shared_foot = 0.25;   // spacings: a fit takes its points from several

/** The points of \p path whose feet are computed: the first of each pass, and on from it those \p apart mm along the path. */
std::vector<std::size_t>
pointsLookedAt(const LinkedPath& path, double apart)
{
  std::vector<std::size_t> looked;
  double way = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const bool begins = i == 0 || beginsPass(path.passes, i);
    way = begins ? 0.0 : way + (path.points[i] - path.points[i - 1]).norm();
    if (begins || way >= apart) {
      looked.push_back(i);
      way = 0.0;
    }
  }
  return looked;
}

/** Points of a path whose feet are known. */
struct LookedAt {
  std::vector<std::uint32_t> points; ///< in their order
  std::vector<CurveFoot> feet;       ///< one for each
};

/** Longest move that starts at each point of the path along it; chunk by chunk, because feet need much memory. Fails if the path
 *  leaves the surface. Points closer together than the fit can tell curvatures apart share a foot. \p kept: the feet. */
Status
allowedSteps(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, std::vector<double>& steps, LookedAt& kept)
{
  const double longest = settings.max_step > 0.0 ? settings.max_step : settings.tool_radius;
  const std::size_t n = path.points.size();
  steps.resize(n);
  const std::vector<std::size_t> looked = pointsLookedAt(path, shared_foot * surface.spacing());
  kept.points.assign(looked.begin(), looked.end());
  const auto stepAt = [&](std::size_t i, const SurfaceFoot& foot) {
    const std::size_t before = i > 0 && !beginsPass(path.passes, i) ? i - 1 : i,
                      after = i + 1 < n && !beginsPass(path.passes, i + 1) ? i + 1 : i;
    const Eigen::Vector3d along = path.points[after] - path.points[before];
    const Eigen::Vector3d tangent = (along - foot.normal * foot.normal.dot(along)).normalized();
    const double curvature = spacingCurvature(settings.tool_radius, foot.normalCurvature(tangent));
    const double step = stepFromChordErrorAtCentre(settings.tool_radius, curvature, settings.chord_error, longest);
    return step_reserve * std::max(step, least_step * longest);
  };
  Polyline queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < looked.size(); begin += report_chunk) {
    const std::size_t end = std::min(looked.size(), begin + report_chunk);
    queries.clear();
    for (std::size_t k = begin; k < end; ++k)
      queries.push_back(path.points[looked[k]]);
    pathFeet(surface, queries, feet);
    const auto off = std::find_if(feet.begin(), feet.end(), [](const SurfaceFoot& f) { return !f.valid; });
    if (off != feet.end())
      return {StatusCode::Failed,
              Diagnostic("the path leaves the {scanned surface} at ", Place(queries[off - feet.begin()]),
                         ": the {scan} has a gap or a ragged rim there; {scan it again, more densely}, or cut the ragged part away")};
    const auto count = static_cast<std::int64_t>(end - begin);
    kept.feet.resize(end);
#pragma omp parallel for schedule(static, 1024)
    for (std::int64_t k = 0; k < count; ++k) {
      kept.feet[begin + k] = {feet[k].position, feet[k].normal, feet[k].nearest_distance, feet[k].nearest};
      const std::size_t next = begin + k + 1 < looked.size() ? looked[begin + k + 1] : n;
      for (std::size_t i = looked[begin + k]; i < next; ++i)
        steps[i] = stepAt(i, feet[k]);
    }
  }
  return Status::success();
}

/** The last point that a straight move from \p first may go to: no point between is farther than \p tolerance from it, and it is
 *  no longer than the points allow. */
std::size_t
straightTo(const LinkedPath& path, const std::vector<double>& steps, std::size_t first, double tolerance)
{
  std::size_t last = first + 1;
  double allowed = std::min(steps[first], steps[last]);
  for (std::size_t next = first + 2; next < path.points.size() && !beginsPass(path.passes, next); ++next) {
    allowed = std::min(allowed, steps[next]);
    const Eigen::Vector3d d = path.points[next] - path.points[first];
    const double square = d.squaredNorm();
    if (square > allowed * allowed || next - first > 64)
      break;
    const double share = 1.0 / std::max(square, 1e-300);
    for (std::size_t k = first + 1; k < next; ++k) {
      const Eigen::Vector3d p = path.points[k] - path.points[first];
      const double t = std::clamp(p.dot(d) * share, 0.0, 1.0);
      if ((p - t * d).squaredNorm() > tolerance * tolerance)
        return last;
    }
    last = next;
  }
  return last;
}

} // namespace

Status
samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, SpiralTurns& turns)
{
  std::vector<SpiralPoint>& points = turns.curve;
  points.clear();
  turns.feet = CurveFeet();
  if (const Status status = checkGiven(path.points.size(), "the linked path"); !status.ok())
    return status;
  if (const Status status = checkBasis(path.basis, {settings.tool_radius, settings.scallop_height}, "the linked path"); !status.ok())
    return status;
  std::vector<double> steps;
  LookedAt looked;
  if (const Status status = allowedSteps(path, surface, settings, steps, looked); !status.ok())
    return status;
  turns.largest_allowed_step = *std::max_element(steps.begin(), steps.end()) / step_reserve;
  std::vector<std::uint32_t> of_point;
  points.reserve(path.points.size());
  of_point.reserve(path.points.size());
  std::size_t at = 0; // in what was looked at
  /** Adds point i of the path. */
  const auto add = [&](std::size_t i, bool begins_pass) {
    points.push_back({path.points[i], path.turns[i], begins_pass});
    while (at < looked.points.size() && looked.points[at] < i)
      ++at;
    of_point.resize(points.size(), CurveFeet::none);
    if (at < looked.points.size() && looked.points[at] == i)
      of_point.back() = static_cast<std::uint32_t>(at);
  };
  add(0, false);
  for (std::size_t i = 0; i + 1 < path.points.size();) {
    if (beginsPass(path.passes, i + 1)) {
      add(++i, true);
      continue;
    }
    const std::size_t next = straightTo(path, steps, i, straight_share * settings.chord_error);
    const Eigen::Vector3d d = path.points[next] - path.points[i];
    const auto parts = std::max(1, static_cast<int>(std::ceil(d.norm() / std::min(steps[i], steps[next]))));
    for (int k = 1; k < parts; ++k)
      points.push_back({path.points[i] + d * k / parts, path.turns[i] + (path.turns[next] - path.turns[i]) * k / parts});
    add(next, false);
    i = next;
  }
  turns.feet = {std::move(looked.feet), std::move(of_point)};
  return Status::success();
}

Status
samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, std::vector<SpiralPoint>& points,
           double& longest_step)
{
  SpiralTurns turns;
  const Status status = samplePath(path, surface, settings, turns);
  points = std::move(turns.curve);
  longest_step = turns.largest_allowed_step;
  return status;
}

} // namespace pcl_spiral
