// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/ridge_planning.h>

#include "planning/field_names.h"
#include "planning/part_surface.h"
#include "planning/pass_locations.h"
#include "planning/pass_mesh.h"

#include "drive/pass_axes.h"
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/ridge/ridge_lines.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double scan_share = 0.3, lines_share = 0.6; // of the progress

bool
hasCutter(const RidgePlanInput& input)
{
  return input.tool.cutter.radius != 0.0;
}

/** What belongs to measured lines, to a ridge in a scan, to a beam, and to a cutter. */
Status
checkInput(const RidgePlanInput& input)
{
  const auto refused = [](const char* text) { return Status(StatusCode::InvalidArgument, text); };
  const bool measured = !input.rail.empty() || !input.generator.empty();
  if (measured != input.rough_points.empty())
    return refused(measured
                       ? "measured lines ({setMeasuredLines}) and rough points ({setRoughPoints}) are both given: leave one of the two out"
                       : "the lines of the ridge are missing: give both ({setMeasuredLines}), or a scan with rough points on the ridge "
                         "({setInputCloud}, {setRoughPoints})");
  if (!measured && !input.cloud)
    return refused("rough points ({setRoughPoints}) are given, but no scan: give the one that holds the ridge ({setInputCloud})");
  if (measured && (input.half_width != 0.0 || input.closed))
    return refused(
        "half width and ring ({setHalfWidth}, {setClosed}) belong to a ridge in a scan, and measured lines are given: leave them "
        "out");
  if (!measured && input.ridge.measuring_error != 0.0)
    return refused("the lines are found in the scan, and so is the noise: leave {RidgeSettings::measuring_error} out");
  if (!input.cloud && (input.leave_out_strays || input.surface.thinning != 0.0 || input.surface.largest_part))
    return refused(
        "settings of a scan are given ({setLeaveOutStrays}, {setThinning}, {setLargestPart}), but no scan: leave them out, or give "
        "one ({setInputCloud})");
  if (input.rows.overlap != 0.0 && input.rows.spot_size == 0.0)
    return refused("an overlap belongs to the spot of a beam: leave {RidgeRowSettings::overlap} out, or set the spot");
  if (hasCutter(input)) {
    const CutterShape& cutter = input.tool.cutter;
    const bool is_ball = cutter.flank_angle == 0.0 && cutter.corner_radius == cutter.radius;
    if (input.rows.tool_radius != 0.0 && !(is_ball && input.rows.tool_radius == cutter.radius))
      return {StatusCode::InvalidArgument, Diagnostic("the rows keep the scallop height of a ball of radius ", input.rows.tool_radius,
                                                      " {mm}, and the cutter is another one: set {RidgeRowSettings::tool_radius} to its "
                                                      "radius, for a cutter that is no ball a {RidgeRowSettings::step_over}")};
    if (input.rows.stand_off != 0.0)
      return refused("a cutter touches the surface: leave {RidgeRowSettings::stand_off} out, or the cutter ({PassSettings::cutter})");
    if (input.rows.spot_size != 0.0)
      return refused("a spot belongs to a beam: for a cutter set {RidgeRowSettings::step_over}, or ball and scallop height");
    if (const Diagnostic fault = faultOf(input.tool.cutter); !fault.empty())
      return {StatusCode::InvalidArgument, Diagnostic("the cutter ({PassSettings::cutter}): ", fault)};
  }
  else if (!input.tool.holder.empty() || input.tool.holder_clearance != 0.0 || input.tool.max_retilt != 0.0 || input.tool.ceiling != 0.0)
    return refused("holder, retilt and ceiling belong to a cutter, and the head of a beam is not checked: set {PassSettings::cutter}, or "
                   "leave them out");
  else if (input.cloud && measured)
    return refused("a beam uses only the measured lines: leave the scan out ({setInputCloud}), give a cutter ({PassSettings::cutter}), or "
                   "rough points in place of the lines ({setRoughPoints})");
  for (const Diagnostic& fault : {rangeFault(input.tool), rangeFault(input.ridge)})
    if (!fault.empty())
      return {StatusCode::InvalidArgument, fault.renamed(ridge_names)};
  return Status::success();
}

/** The scan, without its outliers if asked for, and the surface through its points; null if they form none. */
Status
takeScan(const RidgePlanInput& input, StageClock& clock, RidgePlan& plan)
{
  plan.whole = plan.cloud = input.cloud;
  plan.covers_scan = false; // only the ridge in it
  plan.normals = input.normals;
  if (input.leave_out_strays) {
    if (const Status status = leaveOutStrays(input.surface.threads, plan); !status.ok())
      return status;
    clock.end("outliers");
  }
  const Status status = makePartSurface(input.surface, partOf(input.progress, 0.0, scan_share), plan);
  clock.end("surface");
  return status;
}

Status
findLines(const RidgePlanInput& input, RidgePlan& plan)
{
  plan.fault = RidgeFault::Scan;
  RidgeLines<pcl::PointXYZ> lines;
  lines.setInputCloud(plan.cloud); // not the cutter's surface: its side may differ
  lines.setLargestPart(input.surface.largest_part);
  lines.setThinning(input.surface.thinning);
  lines.setNumberOfThreads(input.surface.threads);
  lines.setRoughPoints(input.rough_points);
  lines.setClosed(input.closed);
  lines.setHalfWidth(input.half_width);
  lines.setReferenceNormal(input.ridge.reference);
  lines.setFlipNormals(input.ridge.flip);
  lines.setQuiet(true);
  lines.setProgressCallback(partOf(input.progress, scan_share, lines_share));
  pcl::PointCloud<pcl::PointXYZ> rail, generator;
  lines.compute(rail, generator);
  if (!lines.getStatus().ok())
    return renamed(lines.getStatus(), ridge_names);
  plan.rail = lines.getRail();
  plan.generator = lines.getGenerator();
  plan.ridge = lines.getRidge();
  plan.found = lines.getReport();
  addRenamed(plan.found->warnings, ridge_names, plan.warnings);
  return Status::success();
}

Status
takeLines(const RidgePlanInput& input, RidgePlan& plan)
{
  plan.fault = RidgeFault::Lines;
  plan.rail = input.rail;
  plan.generator = input.generator;
  if (const Status status = RidgeSurface::make(plan.rail, plan.generator, input.ridge, plan.ridge); !status.ok())
    return renamed(status, ridge_names);
  addRenamed(plan.ridge->report().warnings, ridge_names, plan.warnings);
  return Status::success();
}

Status
makeRows(const RidgePlanInput& input, RidgePlan& plan, DrivePasses& rows)
{
  if (const Status status = planRidgeRows(*plan.ridge, input.rows, rows, plan.rows); !status.ok())
    return renamed(status, ridge_names);
  addRenamed(plan.rows.warnings, ridge_names, plan.warnings);
  PassAxisSettings settings;
  settings.smoothing_length = input.tool.axis_smoothing;
  settings.max_rate = input.tool.max_axis_rate;
  if (!hasCutter(input))
    settings.stand_off = input.rows.stand_off;
  PassAxisReport report;
  const Status status = smoothPassAxes(settings, rows, report);
  plan.warnings.insert(plan.warnings.end(), report.warnings.begin(), report.warnings.end());
  return status;
}

/** A beam at the places of the rows; its spot is below them on the surface. */
void
takeBeam(const RidgePlanInput& input, const DrivePasses& rows, RidgePlan& plan)
{
  const double stand_off = input.rows.stand_off, lean = std::hypot(input.rows.lead, input.rows.tilt);
  plan.passes = beamPasses(rows, stand_off);
  for (const ToolPoses& poses : plan.passes)
    for (std::size_t i = 1; i < poses.size(); ++i)
      plan.length += (poses[i].tip - poses[i - 1].tip).norm();
  if (lean > 0.0 && stand_off != 0.0)
    plan.warnings.push_back(
        Diagnostic("the beam is tilted by about ", lean, " {degrees} at a stand-off of ", stand_off, " {mm}: it meets the surface about ",
                   std::abs(stand_off) * std::tan(lean * degree),
                   " {mm} beside the row, at the contacts in the files; to have the tip at the spot, leave {RidgeRowSettings::stand_off} "
                   "out and add the stand-off to the tool length"));
}

Status
takeCutter(const RidgePlanInput& input, const DrivePasses& rows, RidgePlan& plan)
{
  std::vector<ToolLocations> located;
  if (const Status status = locateCutter(input.tool, input.surface, rows, partOf(input.progress, lines_share, 1.0), plan, located);
      !status.ok())
    return status;
  plan.tool = toolOf(input.tool, plan);
  if (const Status status =
          takeChecked(input.tool, located,
                      "no row has two cutter locations over the part: check that lines and scan are in the same coordinates", plan);
      !status.ok())
    return renamed(status, tool_names);
  warnOfLocations(input.tool, plan);
  return Status::success();
}

Status
planWhole(const RidgePlanInput& input, RidgePlan& plan)
{
  if (const Status status = checkInput(input); !status.ok())
    return status;
  StageClock clock(plan.stages);
  if (input.cloud)
    if (const Status status = takeScan(input, clock, plan); !status.ok())
      return status;
  if (const Status status = input.rough_points.empty() ? takeLines(input, plan) : findLines(input, plan); !status.ok())
    return status;
  clock.end("lines");
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  if (input.progress && !input.progress(lines_share, "rows"))
    return cancelled;
  plan.fault = RidgeFault::Rows;
  DrivePasses rows;
  if (const Status status = makeRows(input, plan, rows); !status.ok())
    return status;
  clock.end("rows");
  if (!hasCutter(input)) {
    takeBeam(input, rows, plan);
    return input.progress && !input.progress(1.0, "done") ? cancelled : Status::success();
  }
  if (!input.cloud) {
    // The faces of the ridge are curved: at a chord error of a ten thousandth of the width, the surface behind them is a hundred times
    // nearer (measured: 1e-5 mm on a ridge 27 mm wide), far below a cutter's tolerance.
    constexpr double share_of_tolerance = 0.2, finest = 1e-4;
    const double width = plan.ridge->generator().length();
    if (const Status status = makeRidgeMesh(*plan.ridge, std::max(share_of_tolerance * input.tool.tolerance, finest * width), plan.mesh);
        !status.ok())
      return status;
    if (input.sample_mesh)
      if (const Status status = sampleMesh(input.tool.cutter.radius, input.tool.threads, plan); !status.ok())
        return status;
    clock.end("mesh");
  }
  const Status status = takeCutter(input, rows, plan);
  clock.end("locations");
  return status;
}

} // namespace

Status
makeRidgeMesh(const RidgeSurface& ridge, double chord_error, SurfaceMesh::ConstPtr& mesh)
{
  if (const Status status = ridgeMesh(ridge, chord_error, mesh); !status.ok())
    return {StatusCode::Failed, Diagnostic("a ridge ", ridge.rail().length(), " {mm} long and ", ridge.generator().length(),
                                           " {mm} wide needs too many triangles, more than a million: machine it in pieces")};
  return Status::success();
}

Status
planRidge(const RidgePlanInput& input, RidgePlan& plan)
{
  plan = RidgePlan();
  const Status status = planWhole(input, plan);
  if (!status.ok()) {
    const RidgeFault fault = plan.fault;
    plan = RidgePlan();
    plan.fault = fault;
  }
  return status;
}

} // namespace pcl_spiral
