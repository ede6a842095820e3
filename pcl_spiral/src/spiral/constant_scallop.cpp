#include <pcl_spiral/spiral/constant_scallop.h>

#include "path_cover.h"
#include "path_end.h"
#include "path_sampling.h"
#include "turn_radius.h"

#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double held_rim = 0.97; // share of the rim's pass that coverPath leaves where it is

double
lengthOf(const LinkedPath& path, bool reversed_alone)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    if (!reversed_alone || path.reversed[i])
      sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

/** Loops with the surface on their right in place of their left. */
void
turnRound(std::vector<ScallopLoop>& loops)
{
  for (ScallopLoop& loop : loops) {
    std::reverse(loop.points.begin(), loop.points.end());
    std::reverse(loop.metric.begin(), loop.metric.end());
    loop.measure();
  }
}

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
}

Status
planPath(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const SpiralSettings& settings,
         const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopFigures& figures)
{
  StepOverOptions options;
  options.tool_radius = settings.tool_radius;
  options.scallop_height = settings.scallop_height;
  StepOverDistance field;
  if (progress && !progress(0.0, "step-over field"))
    return {StatusCode::Cancelled, "cancelled"};
  if (const Status status = measureStepOvers(surface, outlines, options, field); !status.ok())
    return status;
  clock.end("step-over field");
  ScallopLoopSet set;
  if (!makeScallopLoops(field, partOf(progress, 0.3, 0.6), set))
    return {StatusCode::Cancelled, "cancelled"};
  clock.end("scallop loops");
  const bool inward = settings.direction == SpiralDirection::Inward;
  if (inward != (settings.sense == SpiralSense::CounterClockwise))
    turnRound(set.loops);
  if (const Status status = linkLoops(set.loops, path); !status.ok())
    return status;
  clock.end("linking");
  if (progress && !progress(0.7, "coverage"))
    return {StatusCode::Cancelled, "cancelled"};
  trimEnd(path);
  const CoverFigures cover = coverPath(field, held_rim * set.loops.front().length(), path);
  trimEnd(path);
  clock.end("coverage");
  figures.loops = set.loops.size();
  figures.fingers = set.axes.size();
  figures.chain_loops = path.chain_loops;
  figures.bridges = path.bridges;
  figures.dots = path.dots;
  figures.least_length = field.least_length;
  const SharpTurns turns = sharpTurns(path);
  figures.turn_radius = turns.radius;
  figures.least_radius = turns.least_radius;
  figures.sharpest_place = path.points[turns.sharpest];
  figures.farthest = cover.farthest;
  figures.farthest_place = cover.farthest_place;
  if (!inward)
    reversePath(path);
  return Status::success();
}

} // namespace

Status
planConstantScallop(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                    const ProgressCallback& progress, StageClock& clock, SpiralTurns& turns, ScallopFigures& figures)
{
  turns = SpiralTurns();
  figures = ScallopFigures();
  std::vector<BoundaryLoop> outlines;
  for (const LoopType type : {LoopType::Outer, LoopType::Inner})
    for (const BoundaryLoop& loop : loops)
      if (loop.type == type)
        outlines.push_back(loop);
  LinkedPath path;
  if (const Status status = planPath(surface, outlines, settings, progress, clock, path, figures); !status.ok())
    return status;
  figures.reversed_share = lengthOf(path, true) / lengthOf(path, false);
  return samplePath(path, surface, settings, turns.curve, turns.largest_allowed_step);
}

} // namespace pcl_spiral
