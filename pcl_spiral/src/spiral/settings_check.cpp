// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/settings_check.h>

#include "scan_warnings.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/impl/path_size.h>

namespace pcl_spiral {
namespace {

Status
tooLarge(const char* words, double value, double tool_radius, const char* rest)
{
  return {StatusCode::InvalidArgument,
          Diagnostic("the ", words, " is ", SixDigits(value), " {mm}: it must be below the tool radius, which is ", SixDigits(tool_radius),
                     " {mm}", rest)};
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
  if (const Diagnostic fault = rangeFault(s); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (s.scallop_height >= s.tool_radius)
    return tooLarge("scallop height", s.scallop_height, s.tool_radius, "; a hundredth of the radius is usual ({setScallopHeight})");
  if (s.chord_error >= s.tool_radius)
    return tooLarge("chord error", s.chord_error, s.tool_radius, " ({setChordError})");
  if (s.fixed_axis && !(s.fixed_axis->norm() > 1e-9))
    return {StatusCode::InvalidArgument,
            Diagnostic("the fixed tool axis is ", Direction(*s.fixed_axis), ": give a direction such as (0, 0, 1) ({setFixedAxis})")};
  return checkMethod(s);
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
