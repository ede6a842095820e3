// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/published_spiral.h>

#include "published_lines.h"
#include "published_loops.h"
#include "published_path.h"

#include "core/self_crossing.h"
#include "spiral/lines/surface_centre.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/impl/boundary_choice.h>
#include <pcl_spiral/spiral/impl/loop_check.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

/** One run: the stages of the chain; each uses what earlier stages left in the result. */
class PublishedRun {
public:
  PublishedRun(const SurfaceGraph& graph, const SpiralSettings& settings, const ProgressCallback& progress, PublishedResult& result)
  : graph_(graph), settings_(settings), progress_(progress), result_(result), clock_(result.stages)
  {}

  Status findLoops()
  {
    PublishedLoopOptions options;
    options.progress = from(0.0, 0.1, "boundaries");
    const Status status = publishedLoops(graph_, options, result_.loops);
    clock_.end("boundaries");
    return status;
  }

  Status makePath()
  {
    const MlsSurface surface(graph_, 0, ProjectionMethod::DirectionalCentroid);
    std::vector<SpiralPoint> curve;
    if (const Status status = makeLines(surface); !status.ok())
      return status;
    clock_.end("radial lines");
    if (!goOn(0.5, "spiral"))
      return cancelled();
    if (const Status status = publishedCurve(graph_, settings_, result_, curve); !status.ok())
      return status;
    clock_.end("spiral");
    if (const Status status = publishedContacts(surface, settings_, curve, from(0.55, 0.9, "projection"), result_); !status.ok())
      return status;
    clock_.end("projection");
    publishedAxes(settings_, result_);
    clock_.end("tool axis");
    const Status status = checkCrossings();
    clock_.end("crossings");
    return status;
  }

private:
  static Status cancelled() { return {StatusCode::Cancelled, "cancelled"}; }
  bool goOn(double share, const std::string& stage) const { return !progress_ || progress_(share, stage); }
  /** Progress of a stage, mapped from one share of the whole to another. */
  std::function<bool(double)> from(double begin, double end, const std::string& stage) const
  {
    return [=](double share) { return goOn(begin + share * (end - begin), stage); };
  }

  Status findCentre(const MlsSurface& surface, const BoundaryLoop& rim, Eigen::Vector3d& centre)
  {
    const auto asked = settings_.centre;
    const auto found = asked ? std::nullopt : balancedCentre(MlsSurface(graph_), rim.curve);
    if (!asked && !found)
      return {StatusCode::Failed, "no centre was found on the surface: give one"};
    const SurfaceFoot foot = surface.project(asked ? *asked : found->position);
    if (!foot.valid)
      return {StatusCode::InvalidArgument,
              Diagnostic("the centre ", Place(foot.position), " does not lie on the surface: give a point within three ", "spacings (",
                         3.0 * graph_.spacing(), " {mm}) of the {cloud}, inside its rim, or none")};
    centre = foot.position;
    result_.lines.centre = centre;
    result_.lines.centre_settled = asked || found->settled;
    return Status::success();
  }

  /** Warn of holes that are not boundaries, or refuse them. */
  Status lookAtHoles(const BoundaryChoice& choice)
  {
    for (const BoundaryLoop& loop : result_.loops) {
      if (&loop == choice.rim || &loop == choice.inner)
        continue;
      if (settings_.gaps == GapHandling::Refuse)
        return {StatusCode::InvalidInput, Diagnostic("the {scan} has a gap at ", Place(loop.points.front()), ", ", loop.length,
                                                     " {mm} round: {scan it again}, or allow the path to run over it ({setGapHandling})")};
      result_.warnings.push_back(Diagnostic("the hole at ", Place(loop.points.front()), ", ", loop.length,
                                            " {mm} round, is not bridged: the published method cannot bridge holes"));
    }
    return Status::success();
  }

  Status makeLines(const MlsSurface& surface)
  {
    BoundaryChoice choice;
    if (const Status status = chooseBoundaries(result_.loops, settings_.boundary_mode, choice); !status.ok())
      return status;
    if (const Status status = lookAtHoles(choice); !status.ok())
      return status;
    PublishedLineRequest request{surface, *choice.rim, choice.inner, {}, settings_.start_point, settings_.chord_error, {}};
    request.progress = from(0.15, 0.5, "radial lines");
    if (choice.inner && settings_.centre)
      return {StatusCode::InvalidArgument,
              Diagnostic("a centre was given, ", Place(*settings_.centre), ", but the surface has two boundaries: give no centre")};
    if (!choice.inner)
      if (const Status status = findCentre(surface, *choice.rim, request.centre); !status.ok())
        return status;
    PublishedLineReport found;
    const Status status = publishedLines(request, result_.lines, found);
    PublishedReport& figures = result_.figures;
    figures.lines = result_.lines.lines.size();
    figures.unsettled_lines = found.unsettled;
    figures.largest_line_move = found.largest_move;
    for (const RadialLine& line : result_.lines.lines)
      figures.largest_line_deviation = std::max(figures.largest_line_deviation, line.deviation);
    if (found.unsettled > 0)
      result_.warnings.push_back(Diagnostic(found.unsettled, " of ", figures.lines, " radial lines did not converge: they still ",
                                            "moved sideways by up to ", found.largest_move, " {mm}"));
    return status;
  }

  Status checkCrossings() const
  {
    bool going = true;
    const auto crossing = firstSelfCrossing(result_.contacts, result_.normals, settings_.chord_error, [&](double share) {
      going = going && goOn(0.9 + 0.1 * share, "crossings");
      return going;
    });
    if (!going)
      return cancelled();
    if (crossing)
      return {StatusCode::Failed, Diagnostic("the path crosses itself at ", Place(result_.contacts[*crossing]), " in turn ",
                                             result_.turns[*crossing], ": the radial lines there cross or merge")};
    return goOn(1.0, "done") ? Status::success() : cancelled();
  }

  const SurfaceGraph& graph_;
  const SpiralSettings& settings_;
  const ProgressCallback& progress_;
  PublishedResult& result_;
  StageClock clock_;
};

} // namespace

Status
planPublished(const SurfaceGraph& graph, const SpiralSettings& settings, const ProgressCallback& progress, PublishedResult& result)
{
  result = PublishedResult();
  PublishedRun run(graph, settings, progress, result);
  const Status status = run.findLoops();
  return status.ok() ? run.makePath() : status;
}

Status
planPublishedWithin(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                    const ProgressCallback& progress, PublishedResult& result)
{
  result = PublishedResult();
  if (const Status status = checkLoops(graph, loops); !status.ok())
    return status;
  result.loops = loops;
  return PublishedRun(graph, settings, progress, result).makePath();
}

} // namespace pcl_spiral
