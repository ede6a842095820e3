// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/constant_scallop.h>

#include "spiral/field/mesh_distance.h"
#include "spiral/field/scallop_size.h"
#include "spiral/linking/path_cover.h"
#include "spiral/path/path_end.h"
#include "spiral/turns/turn_radius.h"

#include "common/freed_memory.h"
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double held_rim = 0.97; // share of the pass along the rim that coverPath does not move

double
lengthOf(const LinkedPath& path, bool reversed_alone)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    if (!beginsPass(path.passes, i) && (!reversed_alone || path.reversed[i]))
      sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

/** The largest step-over that the height allows varies along \p path: its smallest and largest value, mm. */
std::pair<double, double>
stepOverRange(const LinkedPath& path)
{
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  const auto count = static_cast<std::int64_t>(path.metric.size());
#pragma omp parallel for schedule(static) reduction(min : least) reduction(max : most)
  for (std::int64_t i = 0; i < count; ++i) {
    const double step_over = longestStepOver(path.metric[i]);
    least = std::min(least, step_over);
    most = std::max(most, step_over);
  }
  return {least, most};
}

/** Reverse the loops: the surface is on their right instead of their left. Each keeps its first point. */
void
turnRound(std::vector<ScallopLoop>& loops)
{
  for (ScallopLoop& loop : loops) {
    std::reverse(loop.points.begin() + 1, loop.points.end());
    std::reverse(loop.metric.begin() + 1, loop.metric.end());
    loop.measure();
  }
}

/** Length of all lifts from pass to pass, mm. */
double
liftsOf(const LinkedPath& path)
{
  double sum = 0.0;
  for (const std::size_t i : path.passes)
    sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

/** Reverse every pass and the order of the passes: the uncut side of each pass stays the same, and the pass along the rim comes
 *  last. */
void
reversePath(LinkedPath& path)
{
  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.metric.begin(), path.metric.end());
  std::reverse(path.reversed.begin(), path.reversed.end());
  const float last = path.turns.back();
  std::reverse(path.turns.begin(), path.turns.end());
  for (float& t : path.turns)
    t = last - t;
  std::reverse(path.passes.begin(), path.passes.end());
  for (std::size_t& begin : path.passes)
    begin = path.points.size() - begin;
}

/** The loops with fewer points, enough to look the same in a picture. */
std::vector<Polyline>
forPictures(const std::vector<ScallopLoop>& loops)
{
  constexpr std::size_t most_points = 200000;
  std::size_t all = 0;
  for (const ScallopLoop& loop : loops)
    all += loop.points.size();
  const std::size_t every = all / most_points + 1;
  std::vector<Polyline> lines(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t k = 0; k < loops[i].points.size(); k += every)
      lines[i].push_back(loops[i].points[k]);
  return lines;
}

/** The rim and the holes among \p loops. */
std::vector<BoundaryLoop>
outlinesOf(const std::vector<BoundaryLoop>& loops)
{
  std::vector<BoundaryLoop> outlines;
  for (const LoopType type : {LoopType::Outer, LoopType::Inner})
    for (const BoundaryLoop& loop : loops)
      if (loop.type == type)
        outlines.push_back(loop);
  return outlines;
}

/** What coverPath does not look at is dropped: it needs the places of the nodes, the corners of the triangles and where they are fine. */
void
keepForCoverage(StepOverDistance& field)
{
  field.mesh.triangles = Triangulation(std::move(field.mesh.triangles).release(), {}, {}, {});
  field.mesh.normals = std::vector<Eigen::Vector3f>();
  field.distance = std::vector<double>();
}

StepOverOptions
optionsOf(const SpiralSettings& settings)
{
  StepOverOptions options;
  options.tool_radius = settings.tool_radius;
  options.scallop_height = settings.scallop_height;
  return options;
}

} // namespace

Status
makeStepOverField(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                  const ProgressCallback& progress, StepOverDistance& field)
{
  return measureStepOvers(surface, outlinesOf(loops), optionsOf(settings), field, progress);
}

void
measureLinked(const LinkedPath& path, ScallopReport& figures)
{
  if (!path.metric.empty())
    std::tie(figures.smallest_step_over, figures.largest_step_over) = stepOverRange(path);
  figures.chain_loops = path.chain_loops;
  figures.bridges = path.bridges;
  figures.dots = path.dots;
  if (!path.reversed.empty())
    figures.reversed_share = lengthOf(path, true) / lengthOf(path, false);
  figures.lifts = path.passes.size();
  figures.lift_length = liftsOf(path);
}

Status
makeScallopPath(std::vector<ScallopLoop> loops, const StepOverDistance* field, const SpiralSettings& settings,
                const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopReport& figures)
{
  if (progress && !progress(0.0, "linking"))
    return {StatusCode::Cancelled, "cancelled"};
  const bool inward = settings.direction == SpiralDirection::Inward;
  if (inward != (settings.sense == SpiralSense::CounterClockwise))
    turnRound(loops);
  if (const Status status = linkLoops(loops, path, settings.start_point, settings.one_way); !status.ok())
    return status;
  figures.loops = loops.size();
  const double rim = loops.front().length();
  figures.rim_length = length(loops.front().points, true);
  std::vector<ScallopLoop>().swap(loops); // the path holds their points now
  returnFreedMemory();
  clock.end("linking");
  if (progress && !progress(0.25, "coverage"))
    return {StatusCode::Cancelled, "cancelled"};
  trimEnd(path);
  if (field) {
    CoverReport cover;
    if (!coverPath(*field, held_rim * rim, partOf(progress, 0.25, 1.0), path, cover))
      return {StatusCode::Cancelled, "cancelled"};
    trimEnd(path);
    figures.least_length = field->least_length;
    figures.farthest = cover.farthest;
    figures.farthest_place = cover.farthest_place;
    clock.end("coverage");
  }
  if (settings.start_point)
    figures.start_off = (path.points.front() - *settings.start_point).norm();
  const SharpTurns turns = sharpTurns(path, held_rim * rim);
  figures.turn_radius = turns.radius;
  figures.least_radius = turns.least_radius;
  figures.sharpest_place = path.points[turns.sharpest];
  if (!inward)
    reversePath(path);
  measureLinked(path, figures);
  return Status::success();
}

Status
linkOnField(const StepOverDistance* field, std::vector<ScallopLoop> loops, const SpiralSettings& settings, const ProgressCallback& progress,
            StageClock& clock, LinkedPath& path, ScallopReport& figures)
{
  ScallopLoopSet set;
  set.loops = std::move(loops);
  if (set.loops.empty() && !makeScallopLoops(*field, partOf(progress, 0.0, 0.4), set))
    return {StatusCode::Cancelled, "cancelled"};
  returnFreedMemory();
  figures.fingers = set.axes.size();
  figures.lines = forPictures(set.loops);
  figures.axes = set.axes;
  clock.end("scallop loops");
  return makeScallopPath(std::move(set.loops), field, settings, partOf(progress, 0.4, 1.0), clock, path, figures);
}

Status
planConstantScallop(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                    const ProgressCallback& progress, bool drop, StageClock& clock, SpiralTurns& turns, ScallopReport& figures)
{
  turns = SpiralTurns();
  figures = ScallopReport();
  if (progress && !progress(0.0, "step-over field"))
    return {StatusCode::Cancelled, "cancelled"};
  const StepOverOptions options = optionsOf(settings);
  StepOverMesh mesh;
  if (const Status status = makeStepOverMesh(*surface, outlinesOf(loops), options, mesh); !status.ok())
    return status;
  if (drop)
    surface = Surface::withoutTriangulation(surface);
  StepOverDistance field;
  if (const Status status = measureOnMesh(std::move(mesh), surface->spacing(), options, field, partOf(progress, 0.0, 0.3)); !status.ok())
    return status;
  if (const Status status = checkPathSize(scallopPathSize(field, *surface, settings), surface->area(), settings); !status.ok())
    return status;
  clock.end("step-over field");
  ScallopLoopSet set;
  const ProgressCallback rest = partOf(progress, 0.3, 1.0);
  if (!makeScallopLoops(field, partOf(rest, 0.0, 0.4), set))
    return {StatusCode::Cancelled, "cancelled"};
  keepForCoverage(field);
  LinkedPath path;
  if (const Status status = linkOnField(&field, std::move(set.loops), settings, rest, clock, path, figures); !status.ok())
    return status;
  figures.fingers = set.axes.size();
  figures.axes = std::move(set.axes);
  field = StepOverDistance(); // not beside the feet
  return samplePath(path, *surface, settings, turns);
}

} // namespace pcl_spiral
