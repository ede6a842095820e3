// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/spiral_path.h>

#include "turn_spacing.h"

#include "core/parallel_resize.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/path_reversals.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double turns_apart = 0.5;  // of neighbouring turns
constexpr double steps_apart = 4.0;  // flat step-overs along the path: the ends of a narrow turn do not count as neighbours
constexpr double widest_steps = 5.0; // flat step-overs: metrics allow 4.5, see stepOverMetric

} // namespace

void
measureTurns(const SpiralPath& path, const SpiralSettings& settings, ToolpathReport& figures)
{
  std::optional<std::size_t> crossing;
  measureTurns(path, settings, {}, figures, crossing);
}

void
measureTurns(const SpiralPath& path, const SpiralSettings& settings, const std::function<bool(double)>& go_on, ToolpathReport& figures,
             std::optional<std::size_t>& crossing)
{
  const TurnedPath turned{path.onSurface(), path.turns, path.passes};
  TurnNeighbours neighbours;
  neighbours.counted = betweenEnds(turned);
  figures.reversals = findReversals(turned, neighbours.counted);
  const double flat = stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(settings.tool_radius);
  const bool by_length = settings.method == SpiralMethod::ConstantScallop;
  resizeInParallel(neighbours.along, path.turns.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < path.turns.size(); ++i)
    neighbours.along[i] = by_length ? path.arc_lengths[i] : path.turns[i];
  neighbours.apart = by_length ? steps_apart * flat : turns_apart;
  neighbours.within = widest_steps * flat;
  const MoveReport moves = measureMoves(path, neighbours, settings.chord_error, go_on);
  figures.closest = moves.closest;
  crossing = moves.crossing;
}

Diagnostic
constantScallopRemedy(const SpiralSettings& settings)
{
  Diagnostic without;
  const auto leaveOut = [&without](bool given, const char* setting) {
    if (given)
      without += Diagnostic(without.empty() ? ", without " : " and ", setting);
  };
  leaveOut(settings.centre.has_value(), "a centre ({setCenter})");
  leaveOut(settings.lines != LineMethod::Automatic, "a method for radial lines ({setLineMethod})");
  leaveOut(settings.pitch == Pitch::AlongLine, "a pitch along them ({setPitch})");
  return Diagnostic("choose constant scallop height ({setMethod})", without);
}

Status
checkReversals(const PathReversals& reversals, const SpiralSettings& settings)
{
  if (reversals.count == reversals.at_corners || settings.method == SpiralMethod::ConstantScallop)
    return Status::success();
  return {StatusCode::Failed, Diagnostic(reversalText(reversals), ": ", constantScallopRemedy(settings))};
}

} // namespace pcl_spiral
