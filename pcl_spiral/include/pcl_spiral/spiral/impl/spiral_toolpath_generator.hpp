// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  SpiralToolpathGenerator: the chain of stages.
 */
#pragma once

#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/impl/toolpath_fields.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/spiral/impl/method_choice.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/rim_offset.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/impl/spiral_methods.hpp>
#include <pcl_spiral/spiral/impl/stage_reports.h>
#include <pcl_spiral/spiral/impl/surroundings_check.h>
#include <pcl_spiral/spiral/impl/tight_report.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/surface/impl/thinning_check.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace pcl_spiral {

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeSurface(Surface::ConstPtr& surface)
{
  if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, 0.25)); !status.ok())
    return status;
  reportSurface(*surface, !this->given_surface_, report_);
  if (const Status status = checkRidden(*surface, settings_); !status.ok())
    return status;
  if (const Status status = checkThinning(*surface, settings_.scallop_height); !status.ok())
    return status;
  return checkScale(*surface, settings_, report_.warnings);
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeLoops(Surface::ConstPtr& surface, const Surroundings& around,
                                                                 std::vector<BoundaryLoop>& loops)
{
  const double hole_size = holeSizeBeside(settings_.hole_size, around.keep_outs, settings_.tool_radius);
  loops = given_loops_;
  if (loops.empty()) {
    BoundaryLoops<PointInT, PointNT> boundaries;
    boundaries.setInputSurface(surface);
    boundaries.setHoleSize(hole_size);
    boundaries.setNumberOfThreads(settings_.threads);
    boundaries.setProgressCallback(partOf(progress_, 0.1, 0.35)); // begins where its own surface would be made
    boundaries.setQuiet(true);
    boundaries.compute(loops);
    if (!boundaries.getStatus().ok())
      return boundaries.getStatus();
    gapsToHoles(around, *surface, settings_.tool_radius, loops, report_.warnings);
  }
  BridgedSurface bridged;
  const bool all = methodAsked(settings_) != SpiralMethod::Radial && settings_.boundary_mode == BoundaryMode::Automatic;
  const BoundaryMode mode = all && settings_.holes != HoleHandling::Over ? BoundaryMode::AllBoundaries : settings_.boundary_mode;
  const HoleOptions holes{mode, settings_.holes, settings_.gaps, hole_size};
  if (const Status status = bridgeGaps(std::move(surface), loops, holes, partOf(progress_, 0.35, 0.4), bridged,
                                       given_loops_.empty() ? LoopOrigin::Found : LoopOrigin::Given);
      !status.ok())
    return status;
  reportLoops(bridged, settings_, report_);
  surface = std::move(bridged.surface);
  loops = std::move(bridged.loops);
  return offsetOutlines(surface, loops, settings_.rim_overhang, settings_.hole_margin);
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makeCurve(Surface::ConstPtr& surface, const Surroundings& around, StageClock& clock,
                                                                 TurnAttempt& attempt, std::unique_ptr<BallReach>& reach)
{
  if (given_lines_ && settings_.method == SpiralMethod::ConstantScallop)
    return {StatusCode::InvalidArgument, "radial lines were given, but a path at constant scallop height has none: call "
                                         "{clearRadialLines}, or {setMethod} with {SpiralMethod::Radial}"};
  if (given_lines_) {
    if (const Status status = checkLines(*given_lines_, surface->spacing()); !status.ok())
      return status;
    report_.loops = given_loops_;
    reportNoise(*surface, settings_, report_);
    const Status reached = makeReach(*surface, settings_, beyond_, reach);
    return reached.ok() ? makeOnLines(surface, *given_lines_, clock, attempt) : reached;
  }
  std::vector<BoundaryLoop> loops;
  if (const Status status = makeLoops(surface, around, loops); !status.ok())
    return status;
  attempt.plan.boundaries = report_.boundaries;
  clock.end("boundaries");
  if (const Status status = makeReach(*surface, settings_, beyond_, reach); !status.ok())
    return status;
  clock.end("reach of the ball");
  if (!given_parts_.empty())
    return makeOfParts(surface, loops, clock, attempt);
  switch (methodAsked(settings_)) {
  case SpiralMethod::ConstantScallop: {
    const Status status = makeConstantScallop(surface, loops, true, clock, attempt);
    giveUpTriangles(surface);
    return status;
  }
  case SpiralMethod::Radial:
    return makeRadial(surface, loops, clock, attempt);
  default: {
    const Status status = makeShortest(surface, loops, clock, attempt);
    giveUpTriangles(surface);
    return status;
  }
  }
}

/** The given surroundings, and all of the scan that is not of \p surface. */
template <typename PointInT, typename PointNT, typename PointOutT>
Surroundings
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::allAround(const Surface& surface)
{
  Surroundings around = withSurface(around_, surface);
  const pcl::IndicesPtr part = this->givenIndices();
  const bool of_this_cloud = this->input_ && part && this->input_->size() == surface.inputSize();
  if (!of_this_cloud && surface.report().input < surface.inputSize() && around_.empty())
    report_.warnings.push_back(Diagnostic(
        "the surface was made from ", surface.report().input, " of ", surface.inputSize(),
        " points of a cloud, and what the others show is not known here: the ball may cut into it; give the {cloud} with its indices, "
        "too, before the surface ({setInputCloud}, {setInputSurface})"));
  if (!of_this_cloud)
    return around;
  std::vector<std::uint8_t> is_part(this->input_->size(), 0);
  for (const pcl::index_t i : *part)
    is_part[static_cast<std::size_t>(i)] = 1;
  const auto scan = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<Eigen::Vector3f> others;
  for (std::size_t i = 0; i < is_part.size(); ++i) {
    const Eigen::Vector3f p = (*this->input_)[i].getVector3fMap();
    if (!p.allFinite())
      continue;
    scan->emplace_back(p.x(), p.y(), p.z());
    if (is_part[i] == 0)
      others.push_back(p);
  }
  if (!around.scan) { // what the user gave has no echoes
    around.standing.insert(around.standing.end(), around.beside.begin(), around.beside.end());
    around.beside.clear();
    around.scan = scan;
  }
  for (const Eigen::Vector3f& p : offSurface(surface, others)) {
    const auto contains = [&p](const Prism& prism) { return prism.contains(p.cast<double>()); };
    (std::any_of(around.keep_outs.begin(), around.keep_outs.end(), contains) ? around.kept_out : around.beside).push_back(p);
  }
  return around;
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::run(StageClock& clock, SpiralPath& path)
{
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  if (const Status status = checkGivenParts(given_parts_, settings_, given_lines_.has_value()); !status.ok())
    return status;
  if (settings_.method == SpiralMethod::Published && !modifiers_.empty())
    return {StatusCode::InvalidArgument, "the published method takes no modifiers: take them back, or choose another method ({setMethod})"};
  for (const Prism& prism : around_.keep_outs)
    if (!prism.fault().empty())
      return {StatusCode::InvalidArgument, Diagnostic("the polygon of a keep-out is no area: ", prism.fault())};
  const ThreadLimit limit(settings_.threads);
  Surface::ConstPtr surface;
  if (const Status status = makeSurface(surface); !status.ok())
    return status;
  if (this->given_surface_)
    clock.restart();
  else
    clock.end("surface");
  const Surroundings around = allAround(*surface);
  if (const Status status = makePath(clock, std::move(surface), around, path); !status.ok() || around.empty())
    return status;
  const Status status = checkSurroundings(path, settings_, around, report_);
  clock.end("surroundings");
  return status;
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::makePath(StageClock& clock, Surface::ConstPtr surface, const Surroundings& around,
                                                                SpiralPath& path)
{
  report_.method = settings_.method;
  if (settings_.method == SpiralMethod::Published)
    return makePublished(*surface, clock, path);
  GapReport gaps;
  std::unique_ptr<BallReach> reach;
  {
    TurnAttempt attempt;
    attempt.plan = report_; // what is known so far
    const Status made = makeCurve(surface, around, clock, attempt, reach);
    static_cast<TurnPlan&>(report_) = attempt.plan;
    report_.warnings.insert(report_.warnings.end(), attempt.warnings.begin(), attempt.warnings.end());
    if (!made.ok())
      return made;
    if (const Status status = putOnSurface(attempt.turns, *surface, settings_, partOf(progress_, 0.65, 0.9), path, gaps, reach.get());
        !status.ok())
      return status;
  }
  const std::vector<Eigen::Vector3f> ridden = surface->riddenPoints();
  if (modifiers_.empty())
    surface.reset();
  if (reach)
    reach->dropSurface(); // it is asked for no patch from here on
  clock.end("projection");
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  if (progress_ && !progress_(0.9, "tool axis"))
    return cancelled;
  AxisReport axes;
  if (const Status status = setToolAxes(settings_, path, axes, report_.warnings, ridden); !status.ok())
    return status;
  if (!modifiers_.empty())
    if (const Status status = modifyPath(modifiers_, *surface, settings_, path, axes, gaps); !status.ok())
      return status;
  SpiralSettings used = settings_;
  used.method = report_.method;
  ToolpathReport figures;
  const Status checked = checkPath(path, used, report_.largest_allowed_step, partOf(progress_, 0.96, 1.0), figures, given_parts_.ofUser());
  reportPath(gaps, axes, figures, report_);
  report_.pass_begins = path.passes;
  if (reach)
    reportTight(*reach, path, settings_, report_);
  clock.end("tool axis");
  if (checked.ok() && progress_ && !progress_(1.0, "done"))
    return cancelled;
  return checked;
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::compute(pcl::PointCloud<PointOutT>& path)
{
  path.clear();
  report_ = SpiralReport();
  StageClock clock(report_.stages);
  SpiralPath spiral;
  if (!this->computeBy("SpiralToolpathGenerator", [&] { return run(clock, spiral); }))
    return;
  const ThreadLimit limit(settings_.threads);
  path.resize(spiral.contacts.size());
  const auto count = static_cast<std::int64_t>(path.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    ToolpathFields<PointOutT>::set(path[i], spiral.contacts[i], spiral.normals[i], spiral.axes[i], spiral.arc_lengths[i], spiral.turns[i],
                                   spiral.over_gap[i] != 0);
  if (!spiral.lifts.empty())
    for (std::size_t i = 0; i < path.size(); ++i)
      setToolpathLift(path[i], spiral.lifts[i], 0);
  if (this->input_)
    path.header = this->input_->header;
  path.is_dense = true;
  clock.end("path");
}

} // namespace pcl_spiral
