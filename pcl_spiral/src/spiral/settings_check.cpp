// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/settings_check.h>

#include "scan_warnings.h"
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include <cmath>

namespace pcl_spiral {
namespace {

template <typename Value>
Status
refused(const char* name, Value value, const char* remedy)
{
  return {StatusCode::InvalidArgument, Diagnostic(name, " is ", value, ": ", remedy)};
}

/** Settings of radial lines have no meaning for a path at constant scallop height. */
Status
checkMethod(const SpiralSettings& s)
{
  if (s.holes == HoleHandling::Over && (s.boundary_mode == BoundaryMode::TwoBoundaries || s.boundary_mode == BoundaryMode::AllBoundaries))
    return {StatusCode::InvalidArgument, "the path is set to run over holes ({setHoleHandling}), but holes are set to be boundaries "
                                         "({setBoundaryMode}): remove one of the two settings"};
  if (s.method != SpiralMethod::ConstantScallop)
    return Status::success();
  const char* setting = s.centre                           ? "a centre was given ({setCenter})"
                        : s.lines != LineMethod::Automatic ? "a method for radial lines was chosen ({setLineMethod})"
                        : s.pitch == Pitch::AlongLine      ? "the pitch along radial lines was chosen ({setPitch})"
                                                           : nullptr;
  if (!setting)
    return Status::success();
  return {StatusCode::InvalidArgument, Diagnostic(setting, ", but a path at constant scallop height has no centre and no radial "
                                                           "lines: remove this setting, or choose the radial method ({setMethod})")};
}

} // namespace

Status
checkSettings(const SpiralSettings& s)
{
  if (!(s.tool_radius > 0.0) || !std::isfinite(s.tool_radius))
    return refused("the tool radius", s.tool_radius, "set the ball cutter's radius, above 0 {mm}");
  if (!(s.scallop_height > 0.0) || !std::isfinite(s.scallop_height))
    return refused("the scallop height", s.scallop_height, "set the ridge allowed between turns, above 0 {mm}");
  if (s.scallop_height >= s.tool_radius)
    return refused("the scallop height", s.scallop_height,
                   "it must be smaller than the tool radius; a hundredth of the radius or less is usual");
  if (!(s.chord_error > 0.0) || s.chord_error >= s.tool_radius)
    return refused("the chord error", s.chord_error, "it must be above 0 {mm} and below the tool radius");
  if (!(s.max_step >= 0.0) || !std::isfinite(s.max_step))
    return refused("the longest step", s.max_step, "give a length above 0 {mm}, or 0 for the tool radius");
  if (!(std::abs(s.tilt_angle) < 90.0))
    return refused("the tilt angle", s.tilt_angle, "it must lie between -90 and 90 {degrees}");
  if (!(std::abs(s.lead_angle) < 90.0))
    return refused("the lead angle", s.lead_angle, "it must lie between -90 and 90 {degrees}");
  if (s.fixed_axis && !(s.fixed_axis->allFinite() && s.fixed_axis->norm() > 1e-9))
    return {StatusCode::InvalidArgument,
            Diagnostic("the fixed tool axis is ", Direction(*s.fixed_axis), ": give a direction such as (0, 0, 1)")};
  if (!(s.max_axis_rate > 0.0))
    return refused("the largest axis rate", s.max_axis_rate, "it must be above 0 {degrees} per {mm}");
  if (!(s.axis_smoothing >= 0.0) || !std::isfinite(s.axis_smoothing))
    return refused("the smoothing length of the axis", s.axis_smoothing, "give a length above 0 {mm}, or 0 for none");
  if (!(s.axis_deviation > 0.0) || !(s.axis_deviation < 90.0))
    return refused("the deviation of the axis", s.axis_deviation, "it must lie between 0 and 90 {degrees}");
  if (!(s.feed > 0.0) || !std::isfinite(s.feed))
    return refused("the feed", s.feed, "it must be above 0 {mm/min}");
  if (!(s.thinning >= 0.0) || !std::isfinite(s.thinning))
    return refused("the thinning edge", s.thinning, "give a length above 0 {mm}, or 0 for none");
  if (s.outlier_neighbours < 0 || !(s.outlier_deviations > 0.0))
    return refused("the number of neighbours of the outlier filter", s.outlier_neighbours,
                   "give a count of 0 (none) or more, and a threshold above 0 standard deviations");
  if (const Status status = checkThreads(s.threads); !status.ok())
    return status;
  if (!(s.acceleration > 0.0) || !std::isfinite(s.acceleration))
    return refused("the acceleration", s.acceleration, "it must be above 0 {mm/s2}");
  if (!(s.least_turn_radius >= 0.0) || !(s.least_turn_radius <= 0.25))
    return refused("the least turn radius", s.least_turn_radius, "it must lie between 0 and 0.25 step-overs");
  if (!std::isfinite(s.rim_overhang))
    return refused("the overhang at the rim", s.rim_overhang, "give a length, below 0 inside the rim, or 0 for the rim");
  if (!(s.hole_size >= 0.0) || !std::isfinite(s.hole_size))
    return refused("the hole size", s.hole_size, "give a width above 0 {mm}, or 0 to have it found");
  if (!(s.hole_margin >= 0.0) || !std::isfinite(s.hole_margin))
    return refused("the hole margin", s.hole_margin, "give a length above 0 {mm}, or 0 for none");
  if (const Status status = checkMethod(s); !status.ok())
    return status;
  for (const auto* point : {&s.centre, &s.start_point, &s.view_point})
    if (*point && !(*point)->allFinite())
      return refused("a given point", Place(**point), "its coordinates must be finite");
  return Status::success();
}

Status
checkBasis(const StepOverBasis& made, const StepOverBasis& used, const Diagnostic& what)
{
  const auto differs = [](double a, double b) { return a > 0.0 && b > 0.0 && a != b; };
  const bool radius = differs(made.tool_radius, used.tool_radius);
  if (!radius && !differs(made.scallop_height, used.scallop_height))
    return Status::success();
  return {StatusCode::InvalidArgument, Diagnostic(what, " was made with the ", radius ? "tool radius " : "scallop height ",
                                                  radius ? made.tool_radius : made.scallop_height, " {mm}, but here it is ",
                                                  radius ? used.tool_radius : used.scallop_height, " {mm}: set the same (",
                                                  radius ? "{setToolRadius}" : "{setScallopHeight}", "), or make ", what, " again")};
}

Status
checkScale(const Surface& surface, const SpiralSettings& settings, Diagnostics& warnings)
{
  constexpr double hopeless = 10.0; // times most_path_points: if the area alone needs more, the path is refused at once
  const SurfaceGraph& graph = surface.graph();
  const double across = graph.blocks().box().diagonal();
  if (across < settings.tool_radius)
    warnings.push_back(Diagnostic("the whole {scan} is ", across, " {mm} across, less than the tool radius ", settings.tool_radius,
                                  " {mm}: if it is in metres or inches, scale it to {mm}"));
  const double area = surfaceArea(graph);
  for (const Diagnostic& warning : scanWarnings(graph, settings))
    warnings.push_back(warning);
  return checkPathSize(roughPathSize(area, settings), area, settings, hopeless * most_path_points);
}

} // namespace pcl_spiral
