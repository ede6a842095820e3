// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/drive_planning.h>

#include "planning/column_ends.h"
#include "planning/joined_passes.h"
#include "planning/left_out.h"
#include "planning/part_selection.h"
#include "planning/part_surface.h"
#include "planning/pass_locations.h"
#include "planning/pass_mesh.h"
#include "planning/plan_regions.h"
#include "planning/scallop_check.h"

#include "drive/pass_axes.h"
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/surface/impl/side_text.h>

#include <utility>

namespace pcl_spiral {
namespace {

constexpr double scan_share = 0.3, drive_share = 0.5; // of the progress

const Status cancelled_status(StatusCode::Cancelled, "cancelled");

/** The points of the part, and their surface. */
Status
chooseScan(const DrivePlanInput& input, const PartChoice& choice, const ProgressCallback& progress, StageClock& clock, PassPlan& plan)
{
  SurfaceSettings settings = input.surface;
  settings.part_at = choice.part_at;
  settings.clusters = choice.clusters;
  plan.whole = plan.cloud = input.cloud;
  plan.normals = input.normals;
  // With no radius: locations that enter a keep-out are left out later, so any cutter goes as near as it can.
  if (const Status status = choosePart({input.cloud, input.normals, settings, input.indices}, choice, {}, {}, plan.chosen); !status.ok())
    return status;
  if (plan.chosen.cloud) {
    plan.cloud = plan.chosen.cloud;
    plan.normals = plan.chosen.normals;
  }
  if (progress && !progress(0.0, "part"))
    return cancelled_status;
  if (input.leave_out_strays) {
    if (const Status status = leaveOutStrays(settings.threads, plan); !status.ok())
      return status;
    clock.end("outliers");
  }
  if (const Status status = makePartSurface(settings, partOf(progress, 0.0, scan_share), plan); !status.ok())
    return status;
  clock.end("surface");
  if (const Status status = applyClusterHandling(settings, input.tool.cutter.corner_radius, partOf(progress, 0.0, scan_share), plan);
      !status.ok())
    return status;
  if (const DriveAxisMode mode = input.drive.axisMode(); mode == DriveAxisMode::Surface || mode == DriveAxisMode::LocalPlane)
    for (Diagnostic& warning : sideWarnings(plan.side))
      plan.warnings.push_back(std::move(warning));
  return Status::success();
}

/** The mesh, with the samples that are needed. */
Status
chooseMesh(const DrivePlanInput& input, StageClock& clock, PassPlan& plan)
{
  plan.mesh = input.mesh;
  warnOfMesh(plan);
  if (!input.sample_mesh && !input.drive.goesRound())
    return Status::success();
  const Status status = sampleMesh(input.tool.cutter.radius, input.tool.threads, plan);
  clock.end("samples");
  return status;
}

/** The drive path, or the passes given in its place. */
Status
takePasses(const DrivePlanInput& input, const SurfaceSettings& surface, const ProgressCallback& progress, PassPlan& plan,
           DrivePasses& passes)
{
  if (!input.passes.empty()) {
    passes = input.passes;
    return Status::success();
  }
  DrivePath<pcl::PointXYZ> drive;
  drive.setSettings(input.drive);
  setPart(plan, surface, drive);
  drive.setQuiet(true);
  drive.setProgressCallback(progress);
  drive.compute(passes);
  plan.drive = drive.getReport();
  return drive.getStatus();
}

Status
makePasses(const DrivePlanInput& input, const SurfaceSettings& surface, const ProgressCallback& progress, PassPlan& plan,
           DrivePasses& passes)
{
  if (const Status status = takePasses(input, surface, progress, plan, passes); !status.ok())
    return status;
  PassAxisSettings axes;
  axes.smoothing_length = input.tool.axis_smoothing;
  axes.max_rate = input.tool.max_axis_rate;
  PassAxisReport report;
  const Status status = smoothPassAxes(axes, passes, report);
  plan.warnings.insert(plan.warnings.end(), report.warnings.begin(), report.warnings.end());
  return status;
}

/** Adds the warnings of the drive path and of the locations. */
void
warnOfPath(const DrivePlanInput& input, PassPlan& plan)
{
  plan.warnings.insert(plan.warnings.end(), plan.drive.warnings.begin(), plan.drive.warnings.end());
  warnOfLocations(input.tool, plan);
  if (!input.check_gouges)
    plan.warnings.push_back("the cutter was not checked against the rest of the mesh ({setGougeCheck}): it gouges hollows narrower "
                            "than itself");
}

/** The passes over the region that \p choice chooses. */
Status
planRegion(const DrivePlanInput& input, const PartChoice& choice, const ProgressCallback& progress, PassPlan& plan)
{
  StageClock clock(plan.stages);
  if (const Status status = input.mesh ? chooseMesh(input, clock, plan) : chooseScan(input, choice, progress, clock, plan); !status.ok())
    return status;
  SurfaceSettings surface = input.surface;
  surface.part_at = choice.part_at;
  DrivePasses passes;
  if (const Status status = makePasses(input, surface, partOf(progress, 0.0, drive_share), plan, passes); !status.ok())
    return status;
  clock.end("drive path");
  std::vector<ToolLocations> located;
  if (!input.check_gouges)
    located = standAtContacts(input.tool, passes);
  else if (const Status status = locateCutter(input.tool, surface, passes, partOf(progress, drive_share, 1.0), plan, located); !status.ok())
    return status;
  clock.end("locations");
  plan.tool = toolOf(input.tool, plan);
  plan.gouges_checked = input.check_gouges;
  plan.covers_scan = input.drive.kind != DriveKind::Curve && input.passes.empty();
  leaveOut(input.tool, located, plan);
  if (const Status status =
          takeChecked(input.tool, located, "no pass has two cutter locations over the part; check the drive path and the tool axis", plan);
      !status.ok())
    return status;
  if (input.drive.goesRound())
    warnOfEnds(input, located, plan);
  if (const Status status = checkScallop(input, plan); !status.ok())
    return status;
  warnOfPath(input, plan);
  clock.end("scallop check");
  if (progress && !progress(1.0, "done"))
    return cancelled_status;
  return Status::success();
}

/** Completes what follows from other settings. */
Status
complete(DrivePlanInput& input)
{
  DriveSettings& drive = input.drive;
  if (!drive.cutter)
    return {StatusCode::InvalidArgument, "the cutter is missing: call {setCutter}, such as with CutterShape::ball(6.0)"};
  input.tool.cutter = *drive.cutter;
  if (const Diagnostic fault = faultOf(*drive.cutter); !fault.empty())
    return {StatusCode::InvalidArgument, Diagnostic("the cutter ({setCutter}): ", fault)};
  if (const Diagnostic fault = rangeFault(input.tool); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (drive.scallop_height > 0.0 && drive.step_over == 0.0) {
    const std::optional<double> step = stepForScallop(CutterProfile(*drive.cutter), drive.scallop_height);
    if (!step)
      return {StatusCode::InvalidArgument, Diagnostic("no step-over gives the scallop height of ", drive.scallop_height,
                                                      " {mm} with this cutter: give a step-over ({setStepOver})")};
    drive.step_over = *step;
  }
  if (!input.passes.empty() && (!input.check_gouges || input.regions.size() > 1))
    return {StatusCode::InvalidArgument, Diagnostic("passes of your own ({setDrivePasses}) ",
                                                    input.check_gouges ? "belong to one region: give one ({addRegion})"
                                                                       : "are checked for gouges ({setGougeCheck}): leave that on")};
  if (!input.check_gouges && (!input.mesh || drive.kind != DriveKind::Planes))
    return {StatusCode::InvalidArgument, "only planes over a mesh have contacts without a check for gouges ({setGougeCheck}): leave it on"};
  return Status::success();
}

} // namespace

Status
planDrivePasses(const DrivePlanInput& given, PassPlan& plan)
{
  plan = PassPlan();
  DrivePlanInput input = given;
  if (const Status status = complete(input); !status.ok())
    return status;
  if (input.mesh && (input.leave_out_strays || !input.regions.empty()))
    return {StatusCode::InvalidArgument, Diagnostic(input.leave_out_strays ? "{setLeaveOutStrays}" : "{addRegion}",
                                                    " belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out")};
  if (input.mesh)
    if (const Status status = checkPartOfMesh(input.choice, {}); !status.ok())
      return status;
  const std::vector<PlanRegion> regions = namedRegions(input.regions);
  std::vector<PassPlan> made(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const ProgressCallback progress = progressOf(input.progress, i, regions.size());
    if (const Status status = planRegion(input, choiceOf(input.choice, regions[i]), progress, made[i]); !status.ok())
      return {status.code(), textOfRegion(regions[i].name, status.diagnostic())};
    made[i].region = regions[i].name;
  }
  if (made.size() > 1)
    return joinPasses(made, plan);
  plan = std::move(made.front());
  return Status::success();
}

} // namespace pcl_spiral
