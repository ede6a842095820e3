// SPDX-License-Identifier: BSD-3-Clause
#include "planning/closed_scan.h"

#include "planning/scan_clearance.h"
#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/search/impl/point_selection.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double narrow_cells = 4.0; // narrower than that nothing is a hole: a cell that is missing, and those about it

/** Raised by a quarter of the radius, edges are no sharper than that, and hollows no tighter than three quarters: a fit can follow them. By
 *  half, both are half the radius, and the path is longer. Neither cuts more: with the curvature k of a closed surface, -1/R or more, the
 *  scallop of the tool of radius R is (R - r) / (R (1 + k r)) of that of the smaller ball on the surface raised by r, and so at most as
 *  high. */
constexpr std::array<ClosingTry, 4> tries{{{0.25, false}, {0.5, false}, {0.25, true}, {0.5, true}}};

Status
refuseUnfit(const PlanInput& input)
{
  if (input.mesh)
    return {StatusCode::InvalidArgument,
            "{setBallClosing} belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out"};
  if (input.indices)
    return {StatusCode::InvalidArgument, "{setIndices} were given, and {setBallClosing} needs the whole scan: choose the part by a crop "
                                         "({setCrop}) or a region ({addRegion})"};
  if (!input.choice.keep_outs.empty())
    return {StatusCode::InvalidArgument,
            "a keep-out ({addKeepOut}) does not go with {setBallClosing}, which rides over all that was scanned: leave "
            "the keep-out out, or cut what lies beside it by a crop ({setCrop})"};
  if (input.settings.thinning > 0.0)
    return {StatusCode::InvalidArgument,
            "thinning ({setThinning}) drops points that the ball must not touch, and {setBallClosing} makes an "
            "even surface itself: leave the thinning out"};
  if (input.settings.flip_normals)
    return {StatusCode::InvalidArgument, "{setFlipNormals} turns the side, which {setBallClosing} takes from the tool axis: set the axis "
                                         "({setFixedAxis}), and leave the turn out"};
  return Status::success();
}

/** The scan of \p input without the points that the outlier filter takes for false echoes: the ball goes through these. */
Status
leaveEchoesOut(PlanInput& input)
{
  SpiralSettings& s = input.settings;
  if (s.outlier_neighbours <= 0 || !input.cloud)
    return Status::success();
  if (const Diagnostic fault = rangeFault(static_cast<SurfaceSettings&>(s)); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  const UsablePoints usable = usablePoints(*input.cloud, nullptr);
  const auto kept = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  kept->sensor_origin_ = input.cloud->sensor_origin_;
  for (const std::uint32_t i : statisticalInliers(usable.positions, s.outlier_neighbours, s.outlier_deviations))
    kept->push_back({usable.positions[i].x(), usable.positions[i].y(), usable.positions[i].z()});
  input.cloud = kept;
  s.outlier_neighbours = 0;
  return Status::success();
}

} // namespace

Status
closeScan(const PlanInput& given, const ClosingTry& how, ClosedScan& closed)
{
  closed.input = given;
  SpiralSettings& s = closed.input.settings;
  closed.rounding = how.rounding * s.tool_radius;
  BallClosing<pcl::PointXYZ> closing;
  closing.setInputCloud(given.cloud);
  closing.setToolRadius(s.tool_radius);
  closing.setRounding(closed.rounding);
  closing.setNumberOfThreads(s.threads);
  closing.setQuiet(true);
  if (s.fixed_axis)
    closing.setDirection(*s.fixed_axis);
  else if (s.view_point)
    closing.setViewPoint(*s.view_point);
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  closing.compute(*points);
  if (!closing.getStatus().ok())
    return closing.getStatus();
  const ClosingFigures& figures = closing.getFigures();
  if (figures.covered > 0)
    closed.warnings.push_back(
        Diagnostic("seen along the tool axis, ", 100.0 * static_cast<double>(figures.covered) / static_cast<double>(figures.points),
                   " % of the points of the {scan} lie under overhangs or in folds that a ball of ", s.tool_radius,
                   " {mm} cannot enter ({setBallClosing}): material stays there; scan and cut from another side, or take a smaller ball "
                   "({setToolRadius})"));
  closed.input.cloud = points;
  closed.input.normals.reset();
  s.heights = closing.getHeightGrid();
  s.view_point.reset();
  s.fixed_axis = s.heights->along();
  s.tool_radius -= closed.rounding;
  if (how.turned)
    s.sense = s.sense == SpiralSense::Clockwise ? SpiralSense::CounterClockwise : SpiralSense::Clockwise;
  if (!(s.hole_size > 0.0))
    s.hole_size = narrow_cells * figures.cell;
  closed.input.modifiers.push_back(std::make_shared<const ScanClearance>(closing.getDropBall(), *s.heights));
  return Status::success();
}

void
moveToScan(double rounding, SpiralPlan& plan)
{
  pcl::PointCloud<ToolpathPoint>& path = *plan.path;
  const std::vector<std::size_t>& passes = plan.report.pass_begins;
  double length = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    ToolpathPoint& p = path[i];
    const Eigen::Vector3d contact = p.getVector3fMap().cast<double>() - rounding * p.getNormalVector3fMap().cast<double>();
    p.getVector3fMap() = contact.cast<float>();
    if (i > 0 && !std::binary_search(passes.begin(), passes.end(), i))
      length += (contact - before).norm();
    p.arc_length = length;
    before = contact;
  }
  plan.report.path_length = length;
  plan.settings.tool_radius += rounding;
  plan.tool.cutter = CutterShape::ball(plan.settings.tool_radius, plan.tool.cutter.flank_length);
}

Status
planClosed(const PlanInput& whole, const std::function<Status(const PlanInput&, double, SpiralPlan&)>& run, SpiralPlan& plan)
{
  if (const Status status = refuseUnfit(whole); !status.ok())
    return status;
  PlanInput given = whole;
  if (const Status status = leaveEchoesOut(given); !status.ok())
    return status;
  Status first = Status::success();
  std::vector<PlanAttempt> failed;
  for (const ClosingTry& how : tries) {
    std::vector<StageCost> stages;
    StageClock clock(stages);
    ClosedScan closed;
    if (const Status status = closeScan(given, how, closed); !status.ok())
      return status;
    clock.end("ball closing");
    Status status = run(closed.input, closed.rounding, plan);
    clock.restart();
    if (status.ok())
      status =
          checkClear(*plan.path, given.settings.tool_radius, gougeTolerance(given.settings.chord_error, plan.report.noise), *given.cloud);
    clock.end("clearance");
    if (status.ok()) {
      plan.cloud = given.cloud; // what pictures show below the path: the closed scan is raised
      for (SpiralPlan& region : plan.regions)
        region.cloud = given.cloud;
      plan.attempts.insert(plan.attempts.begin(), failed.begin(), failed.end());
      if (how.turned)
        closed.warnings.push_back("the path runs in the other sense than asked for ({setSense}): in that one no path was found over the "
                                  "closed scan ({setBallClosing})");
      plan.report.warnings.insert(plan.report.warnings.end(), closed.warnings.begin(), closed.warnings.end());
      plan.report.stages.insert(plan.report.stages.begin(), stages.begin(), stages.end());
      return status;
    }
    failed.insert(failed.end(), plan.attempts.begin(), plan.attempts.end());
    if (first.ok())
      first = status;
    const bool final = status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::Cancelled;
    if (final || &how == &tries.back()) {
      plan = SpiralPlan();
      plan.attempts = std::move(failed);
      return final ? status : first;
    }
  }
  return first;
}

} // namespace pcl_spiral
