// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  SpiralToolpathGenerator: turns by each method.
 */
#pragma once

#include <pcl_spiral/spiral/impl/loop_check.h>
#include <pcl_spiral/spiral/impl/method_choice.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/impl/stage_reports.h>
#include <pcl_spiral/spiral/impl/tight_places.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

namespace pcl_spiral {

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeLines(const Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops,
                                                                 RadialLineSet& lines)
{
  if (given_loops_.empty())
    if (const Status status = checkFoundLoops(surface->graph(), loops); !status.ok())
      return status;
  RadialLines<PointInT, PointNT> radial;
  radial.setInputSurface(surface);
  radial.setBoundaryLoops(loops);
  if (settings_.centre)
    radial.setCenter(*settings_.centre);
  if (settings_.start_point)
    radial.setStartPoint(*settings_.start_point);
  radial.setLineMethod(settings_.lines);
  radial.setTolerance(lineTolerance(settings_));
  radial.setFitTolerance(lineFitTolerance(settings_));
  radial.setNumberOfThreads(settings_.threads);
  radial.setProgressCallback(partOf(progress_, 0.2, 0.6));
  radial.setQuiet(true);
  radial.compute(lines);
  return radial.getStatus();
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeOnLines(Surface::ConstPtr& surface, const RadialLineSet& lines,
                                                                   StageClock& clock, TurnAttempt& attempt)
{
  attempt.plan.method = SpiralMethod::Radial;
  reportLines(lines, settings_, attempt.plan, attempt.warnings);
  const double area = surface->area();
  if (given_lines_ || methodAsked(settings_) == SpiralMethod::Radial)
    giveUpTriangles(surface); // the projection needs only neighbourhoods; makeShortest may need it
  clock.end("radial lines");
  if (progress_ && !progress_(0.6, "spiral"))
    return {StatusCode::Cancelled, "cancelled"};
  if (settings_.tight == TightHandling::Refuse)
    if (const Status status = checkLinesFit(lines.lines, *surface, settings_.tool_radius); !status.ok())
      return status;
  const Status status = makeTurns(lines, surface->spacing(), area, settings_, attempt.turns);
  reportTurns(attempt.turns, attempt.plan, attempt.warnings);
  clock.end("spiral");
  return status;
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeRadial(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops,
                                                                  StageClock& clock, TurnAttempt& attempt)
{
  if (settings_.hole_margin > 0.0 && attempt.plan.boundaries > 1)
    return {StatusCode::InvalidArgument, "turns of the radial method begin at the edge of the hole, but a margin about holes is asked "
                                         "for ({setHoleMargin}): choose constant scallop height ({setMethod}), or leave the margin out"};
  RadialLineSet lines;
  if (const Status status = makeLines(surface, loops, lines); !status.ok())
    return status;
  return makeOnLines(surface, lines, clock, attempt);
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeConstantScallop(Surface::ConstPtr& surface,
                                                                           const std::vector<BoundaryLoop>& loops, bool alone,
                                                                           StageClock& clock, TurnAttempt& attempt)
{
  attempt.plan.method = SpiralMethod::ConstantScallop;
  ScallopReport figures;
  const Status status = planConstantScallop(surface, loops, settings_, partOf(progress_, 0.4, 0.65), alone && modifiers_.empty(), clock,
                                            attempt.turns, figures);
  attempt.plan.largest_allowed_step = attempt.turns.largest_allowed_step;
  if (status.ok())
    reportScallop(figures, settings_, attempt.plan, attempt.warnings);
  return status;
}

/** Of what the user gave. The checks are those of constant scallop height, which do not take turns for rings one inside the other. */
template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeOfParts(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops,
                                                                   StageClock& clock, TurnAttempt& attempt)
{
  attempt.plan.method = SpiralMethod::ConstantScallop;
  ScallopReport figures;
  const Status status = planGiven(given_parts_, *surface, loops, settings_, partOf(progress_, 0.4, 0.65), clock, attempt.turns, figures);
  attempt.plan.largest_allowed_step = attempt.turns.largest_allowed_step;
  attempt.plan.own_curve = given_parts_.ofUser();
  if (status.ok())
    reportScallop(figures, settings_, attempt.plan, attempt.warnings);
  clock.end("curve");
  return status;
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeShortest(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops,
                                                                    StageClock& clock, TurnAttempt& attempt)
{
  const MethodForesight foresight = foreseeMethods(*surface, loops, settings_);
  report_.foreseen_radial = foresight.radial_length;
  report_.foreseen_scallop = foresight.scallop_length;
  clock.end("choice of method");
  const TurnAttempt first = attempt;
  if (foresight.method == SpiralMethod::Radial) {
    const Status radial = makeRadial(surface, loops, clock, attempt);
    const Diagnostic why_not = whyNotRadial(radial, attempt.turns);
    if (why_not.empty())
      return radial;
    attempt = first;
    attempt.warnings.push_back(Diagnostic(
        "the path was made at constant scallop height, though the radial method was foreseen to take less time: with it, ", why_not));
    const Status scallop = makeConstantScallop(surface, loops, true, clock, attempt);
    return scallop.code() == StatusCode::Failed && !radial.ok() ? neitherMethod(scallop, radial) : scallop;
  }
  const Status scallop = makeConstantScallop(surface, loops, !foresight.why_not_radial.empty(), clock, attempt);
  if (scallop.code() != StatusCode::Failed)
    return scallop;
  if (!foresight.why_not_radial.empty())
    return foresight.radial_fails ? neitherMethod(scallop, {StatusCode::Failed, foresight.why_not_radial}) : scallop;
  attempt = first;
  attempt.warnings.push_back(
      Diagnostic("the radial method made the path, though a shorter one was foreseen at constant scallop height: ", scallop.diagnostic()));
  const Status radial = makeRadial(surface, loops, clock, attempt);
  if (radial.code() == StatusCode::Failed)
    return neitherMethod(scallop, radial);
  return radial.ok() && curveReversals(attempt.turns.curve).count > 0 ? scallop : radial;
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makePublished(const Surface& surface, StageClock& clock, SpiralPath& path)
{
  if (given_lines_)
    return {StatusCode::InvalidArgument, "radial lines were given, but the published method makes its own: call "
                                         "{clearRadialLines}, or {setMethod} with another method"};
  PublishedResult published;
  const ProgressCallback progress = partOf(progress_, 0.25, 1.0);
  const Status status = given_loops_.empty() ? planPublished(surface.graph(), settings_, progress, published)
                                             : planPublishedWithin(surface.graph(), given_loops_, settings_, progress, published);
  for (const StageCost& stage : published.stages)
    report_.stages.push_back(stage);
  clock.restart();
  reportPublished(surface, settings_, published, report_, path);
  if (!status.ok())
    return status;
  GapReport gaps;
  const Status marked = measureGaps(path, settings_, gaps);
  reportGaps(gaps, report_);
  return marked;
}

} // namespace pcl_spiral
