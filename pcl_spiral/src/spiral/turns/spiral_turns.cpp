// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/spiral_path.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/radial_least_length.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>

namespace pcl_spiral {
namespace {

/** Warning of ridges at corners above the scallop height; empty if there are none. */
Diagnostic
cornerWarning(const CornerRidge& ridge, const SpiralSettings& settings)
{
  constexpr double much = 1.05; // times the scallop height
  const double height = settings.scallop_height;
  if (ridge.height <= much * height)
    return {};
  const Diagnostic left = ridge.height < settings.tool_radius
                              ? Diagnostic("ridges rise to ", ridge.height, " {mm}, above the scallop height of ", height, " {mm}")
                              : "material is left uncut";
  return Diagnostic("near the corner of the outline at ", Place(ridge.corner), " turns lie farther apart than along its sides: ", left,
                    "; with a scallop height of ", ridge.remedy, " {mm} a longer path leaves about ", height, " {mm} there");
}

} // namespace

Status
makeTurns(const RadialLineSet& lines, double spacing, double area, const SpiralSettings& settings, SpiralTurns& turns)
{
  turns = SpiralTurns();
  TurnFunction function(lines.lines, settings, spacing);
  if (const Status status = function.compute(); !status.ok())
    return status;
  if (const Status status = checkPathSize(function.pathSize(), area, settings); !status.ok())
    return status;
  SpiralCurve spiral(lines.lines, function, settings, spacing);
  spiral.setRim(lines.rim, lines.rim_corners);
  if (!lines.inner.empty())
    spiral.setInner(lines.inner, lines.inner_corners);
  turns.curve = spiral.sample();
  turns.smallest_step_over = function.smallestStepOver();
  turns.largest_step_over = function.largestStepOver();
  turns.largest_allowed_step = spiral.largestAllowedStep();
  turns.least_length = leastLength(lines, settings);
  turns.corner_ridge = function.highestCornerRidge();
  if (const Diagnostic warning = cornerWarning(turns.corner_ridge, settings); !warning.empty())
    turns.warnings.push_back(warning);
  return Status::success();
}

} // namespace pcl_spiral
