// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/path_reversals.h>
#include <pcl_spiral/spiral/impl/radial_least_length.h>
#include <pcl_spiral/spiral/impl/stage_reports.h>

#include "surface/noise_warning.h"
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double far_start = 0.05; // of the rim's length: a path that begins farther from the given place is reported

void
markGaps(const Surface& surface, const Polyline& contacts, std::vector<std::uint8_t>& over_gap)
{
  const auto count = static_cast<std::int64_t>(contacts.size());
  over_gap.resize(contacts.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    const std::uint32_t nearest = surface.graph().blocks().nearest(contacts[i]);
    over_gap[i] = isOverGap(surface, contacts[i], nearest, (surface.position(nearest) - contacts[i]).norm());
  }
}

HoleReport
holeOf(const BoundaryLoop& loop)
{
  HoleReport hole;
  for (const Eigen::Vector3d& p : loop.curve)
    hole.place += p / static_cast<double>(loop.curve.size());
  for (const Eigen::Vector3d& p : loop.curve)
    hole.width = std::max(hole.width, 2.0 * (p - hole.place).norm());
  return hole;
}

/** Report holes that the path runs round, gaps that it runs over, and voids, which are too narrow to be loops. */
void
reportHoles(const BridgedSurface& bridged, SpiralReport& report)
{
  for (const BoundaryLoop& loop : bridged.loops)
    if (loop.type == LoopType::Inner)
      report.holes.push_back(holeOf(loop));
  for (const BridgedGap& gap : bridged.gaps)
    report.holes.push_back(
        {gap.points > 0 ? gap.centre : holeOf(gap.loop).place, gap.points > 0 ? gap.width : holeOf(gap.loop).width, HoleHandling::Over});
  const std::size_t before = report.holes.size();
  const HoleReport* widest = nullptr;
  for (const ScanVoid& found : bridged.surface->voids().voids()) {
    const auto is_hole = [&](const HoleReport& hole) { return (hole.place - found.place).norm() < 0.5 * hole.width; };
    if (std::none_of(report.holes.begin(), report.holes.begin() + static_cast<std::ptrdiff_t>(before), is_hole))
      report.holes.push_back({found.place, found.width, HoleHandling::Over});
  }
  for (std::size_t i = before; i < report.holes.size(); ++i)
    if (!widest || report.holes[i].width > widest->width)
      widest = &report.holes[i];
  if (widest)
    report.warnings.push_back(Diagnostic("the {scan} has ", report.holes.size() - before, " narrow place(s) without points, up to ",
                                         widest->width, " {mm} wide, for example at ", Place(widest->place),
                                         ": the path runs over them and its points there are marked; if they are holes of the part, set "
                                         "the smallest width of a hole ({setHoleSize})"));
}

} // namespace

void
reportSurface(const Surface& surface, bool made, SpiralReport& report)
{
  const SurfaceReport& counts = surface.report();
  report.input_points = counts.input;
  report.nonfinite_points = counts.nonfinite;
  report.duplicate_points = counts.duplicate;
  report.surplus_points = counts.surplus;
  report.outlier_points = counts.outlier + counts.isolated + counts.clustered;
  report.left_out_parts = counts.separate_parts;
  report.left_out_points = counts.other_part;
  report.used_points = counts.used;
  report.passes = made ? counts.passes : 0;
  report.spacing = surface.spacing();
  report.noise = surface.noise();
  report.side = surface.side();
  report.projection_neighbours = surface.fit().neighbours();
  report.warnings = surface.warnings();
}

void
reportNoise(const Surface& surface, const SpiralSettings& settings, SpiralReport& report)
{
  if (const auto warning = noiseWarning(surface.fit(), "scallop height", settings.scallop_height))
    report.warnings.push_back(*warning);
}

void
reportLoops(const BridgedSurface& bridged, const SpiralSettings& settings, SpiralReport& report)
{
  report.loops = bridged.loops;
  reportHoles(bridged, report);
  for (const BridgedGap& gap : bridged.gaps)
    if (gap.points > 0) // gaps that were not filled are among the loops
      report.loops.push_back(gap.loop);
  report.passes += report.loops.size() > bridged.loops.size(); // the surface was made again with the added points
  report.boundaries = 1;
  for (const BoundaryLoop& loop : bridged.loops)
    report.boundaries += loop.type == LoopType::Inner;
  const Surface& surface = *bridged.surface;
  report.spacing = surface.spacing();
  report.noise = surface.noise();
  report.projection_neighbours = surface.fit().neighbours();
  report.warnings.insert(report.warnings.end(), bridged.warnings.begin(), bridged.warnings.end());
  reportNoise(surface, settings, report);
}

void
reportLines(const RadialLineSet& lines, const SpiralSettings& settings, TurnPlan& plan, Diagnostics& warnings)
{
  plan.boundaries = lines.inner.empty() ? 1 : 2;
  plan.centre = lines.centre;
  plan.centre_settled = lines.centre_settled;
  plan.harmonic_lines = lines.harmonic;
  plan.line_error = lines.largest_interpolation_error;
  plan.line_tolerance = lineTolerance(settings);
  for (const RadialLine& line : lines.lines) {
    Polyline points;
    for (std::size_t k = 0; k < line.feet.size(); k += 4)
      points.push_back(line.feet[k].position);
    plan.radial_lines.push_back(std::move(points));
    plan.unsettled_lines += line.unsettled > 0.0;
    plan.largest_unsettled = std::max(plan.largest_unsettled, line.unsettled);
  }
  if (lines.harmonic && settings.lines == LineMethod::Automatic && !lines.why_harmonic.empty())
    warnings.push_back(Diagnostic("harmonic radial lines were used: ", lines.why_harmonic));
  if (!lines.centre_settled)
    warnings.push_back(Diagnostic("the search for the centre did not converge; the centre is now at ", Place(lines.centre),
                                  ": check that the turns around it look good, or give a centre "
                                  "({setCenter})"));
  // A slightly wrong line still lies on the surface and in order, so turns there have the same distance as elsewhere.
  if (plan.largest_unsettled > plan.line_tolerance)
    warnings.push_back(Diagnostic(plan.unsettled_lines, " of ", lines.lines.size(),
                                  " radial lines did not converge: the last step still moved one of them by ", plan.largest_unsettled,
                                  " {mm} sideways, but only ", plan.line_tolerance,
                                  " {mm} are allowed; choose harmonic lines, which need no such steps ({setLineMethod})"));
  if (plan.line_error > plan.line_tolerance)
    warnings.push_back(Diagnostic("turns between radial lines may be wrong by ", plan.line_error, " {mm}, but only ", plan.line_tolerance,
                                  " {mm} are allowed: the points of the {scan} are too far apart for "
                                  "closer lines; {scan more densely}, or check the ridge heights ({MaterialRemoval})"));
}

void
reportScallop(const ScallopReport& figures, const SpiralSettings& settings, TurnPlan& plan, Diagnostics& warnings)
{
  plan.scallop_loops = figures.loops;
  plan.chain_loops = figures.chain_loops;
  plan.bridges = figures.bridges;
  plan.fingers = figures.fingers;
  plan.scallop_lines = figures.lines;
  plan.finger_axes = figures.axes;
  plan.reversed_share = figures.reversed_share;
  plan.lift_length = figures.lift_length;
  plan.least_length = figures.least_length;
  plan.smallest_step_over = figures.smallest_step_over;
  plan.largest_step_over = figures.largest_step_over;
  plan.turn_radius = figures.turn_radius;
  plan.sharpest_place = figures.sharpest_place;
  if (!(figures.rim_length > 0.0))
    return; // a curve or a linked path was given, and its rim is not known
  if (figures.start_off > far_start * figures.rim_length)
    warnings.push_back(Diagnostic("the path reaches the rim ", figures.start_off,
                                  " {mm} from the given start point: the inner loops "
                                  "lead to no closer place; give no start point, or give one where the path is now ({setStartPoint})"));
  if (figures.turn_radius < settings.least_turn_radius)
    warnings.push_back(Diagnostic("the path has bends sharper than the given radius of ", settings.least_turn_radius,
                                  " step-overs: 0.1 % of its length has a radius below ", figures.turn_radius, ", the sharpest bend has ",
                                  figures.least_radius, " at ", Place(figures.sharpest_place),
                                  ": reduce the feed there; a smaller radius ({setLeastTurnRadius}) removes this warning"));
  const double ridge = 4.0 * figures.farthest * figures.farthest * settings.scallop_height;
  if (figures.farthest > 0.52)
    warnings.push_back(Diagnostic("a ridge of about ", ridge, " {mm} is left at ", Place(figures.farthest_place),
                                  ", above the scallop height of ", settings.scallop_height,
                                  " {mm}: set a lower scallop height if that is too much"));
}

void
reportTurns(const SpiralTurns& turns, TurnPlan& plan, Diagnostics& warnings)
{
  plan.smallest_step_over = turns.smallest_step_over;
  plan.largest_step_over = turns.largest_step_over;
  plan.least_length = turns.least_length;
  plan.largest_allowed_step = turns.largest_allowed_step;
  plan.corner_ridge = turns.corner_ridge.height;
  warnings.insert(warnings.end(), turns.warnings.begin(), turns.warnings.end());
}

void
reportGaps(const GapReport& gaps, SpiralReport& report)
{
  report.gap_points = gaps.points;
  report.gap_length = gaps.length;
  if (gaps.points > 0)
    report.warnings.push_back(Diagnostic(gaps.points, " path points, ", gaps.length,
                                         " {mm} of path, lie over {gaps of the scan} or beyond its rim, where the surface is only "
                                         "estimated; they are marked"));
}

void
reportPath(const GapReport& gaps, const AxisReport& axes, const ToolpathReport& path, SpiralReport& report)
{
  reportGaps(gaps, report);
  report.largest_axis_change = axes.largest_change;
  report.largest_axis_rate = axes.largest_rate;
  report.largest_axis_deviation = axes.largest_deviation;
  report.largest_axis_lean = axes.largest_lean;
  report.deviating_points = axes.deviating_points;
  report.turns = path.turns;
  report.path_points = path.points;
  report.path_length = path.length;
  report.largest_gap = path.largest_gap;
  reportSpacing(path, report);
}

void
reportPublished(const Surface& surface, const SpiralSettings& settings, PublishedResult& published, SpiralReport& report, SpiralPath& path)
{
  const PublishedReport& figures = published.figures;
  if (!published.lines.lines.empty())
    reportLines(published.lines, settings, report, report.warnings);
  report.loops = std::move(published.loops);
  report.unsettled_lines = figures.unsettled_lines;
  report.largest_unsettled = figures.largest_line_move;
  report.smallest_step_over = report.largest_step_over = figures.step_over;
  report.largest_allowed_step = figures.step;
  report.largest_gap = figures.longest_move;
  report.largest_axis_change = figures.largest_axis_change;
  report.warnings.insert(report.warnings.end(), published.warnings.begin(), published.warnings.end());
  if (published.axes.empty()) // it failed before there was a path
    return;
  report.turns = static_cast<std::size_t>(std::lround(std::abs(published.turns.back() - published.turns.front())));
  report.path_points = published.contacts.size();
  report.path_length = published.arc_lengths.back();
  markGaps(surface, published.contacts, path.over_gap);
  path.contacts = std::move(published.contacts);
  path.normals = std::move(published.normals);
  path.axes = std::move(published.axes);
  path.arc_lengths = std::move(published.arc_lengths);
  path.turns = std::move(published.turns);
  report.least_length = leastLength(published.lines, settings);
  ToolpathReport measured;
  measureTurns(path, settings, measured);
  reportSpacing(measured, report);
  if (measured.reversals.count > 0)
    report.warnings.push_back(Diagnostic(reversalText(measured.reversals), ": choose constant scallop height ({setMethod})"));
}

} // namespace pcl_spiral
