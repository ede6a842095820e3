// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan_attempt.h"

#include "planning/mesh_samples.h"
#include "planning/tool_way.h"
#include "planning/uncut_strips.h"

#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double surface_share = 0.25; // of the progress of a path

AttemptResult
refused(Refusal why, const Status& status, bool late)
{
  const bool final = status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::Cancelled;
  return {status, final ? Refusal::Input : why, late && !final};
}

/** Whether turns were made before the generator of \p report ended. */
bool
madeTurns(const SpiralReport& report)
{
  return std::any_of(report.stages.begin(), report.stages.end(),
                     [](const StageCost& stage) { return stage.name == "step-over field" || stage.name == "radial lines"; });
}

/** How far the tool axis leans from the normal, degrees: the tilt asked for, and what smoothing may add. */
double
leanOf(const SpiralSettings& s)
{
  const double asked = std::acos(std::cos(s.tilt_angle * degree) * std::cos(s.lead_angle * degree)) / degree;
  return std::min(most_lean, asked + s.axis_deviation);
}

/** The surface of the part, or of the samples of a mesh. */
Status
makeSurface(const PlanInput& input, const PartChoice& choice, const ProgressCallback& progress, SpiralPlan& plan)
{
  SurfaceSettings settings = input.settings;
  settings.part_at = choice.part_at;
  settings.clusters = choice.clusters;
  if (plan.mesh) { // its faces define the side, and are turned already
    settings.trust_normals = true;
    settings.flip_normals = false;
  }
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(plan.cloud);
  scanned.setInputNormals(plan.mesh ? plan.mesh->normals : plan.normals);
  scanned.setSettings(settings);
  scanned.setQuiet(true);
  scanned.setProgressCallback(partOf(progress, 0.0, surface_share));
  scanned.compute(plan.surface);
  return scanned.getStatus();
}

/** Whether the surface is made before the path, because more than the planner needs it. */
bool
needsSurface(const PlanInput& input, const PartChoice& choice, const SpiralPlan& plan)
{
  // The other parts and the clusters are looked at again when the path is there.
  return plan.mesh || input.keep_surface || input.kept_surface || !plan.part.beside.empty() || choice.part_at ||
         input.settings.largest_part || choice.clusters == ClusterHandling::Ride ||
         (!input.holder.empty() && choice.clusters == ClusterHandling::LeaveOut);
}

/** The settings for the generator. */
SpiralSettings
settingsFor(const PlanInput& input, const PartChoice& choice, const SpiralPlan& plan)
{
  SpiralSettings settings = input.settings;
  settings.part_at = choice.part_at;
  settings.clusters = choice.clusters;
  settings.hole_size = holeSizeBeside(settings.hole_size, choice.keep_outs, settings.tool_radius);
  if (plan.mesh) {
    settings.hole_size = meshHoleSize(input.settings, *plan.mesh);
    settings.trust_normals = true;
    settings.flip_normals = false; // the mesh is turned already
  }
  return settings;
}

/** What the scan has beside the part, and the keep-outs. */
Surroundings
surroundingsOf(const SpiralPlan& plan)
{
  Surroundings around;
  around.keep_outs = plan.part.keep_outs;
  around.kept_out = plan.part.kept_out;
  if (!plan.settings.heights) // a closed scan is free of itself, and the path is kept clear of every point
    around.beside = plan.part.beside;
  around.scan = plan.whole;
  around.of_mesh = plan.mesh.has_value();
  return around;
}

/** Chooses the part, and makes its surface if it is needed. */
AttemptResult
choose(const PlanInput& input, const PartChoice& choice, const StripChoice& strips, const ProgressCallback& progress, StageClock& clock,
       SpiralPlan& plan)
{
  plan.part.part_at = choice.part_at;
  if (!plan.mesh) {
    const WholeScan scan{input.cloud, input.normals, input.settings, input.indices};
    if (const Status status = choosePart(scan, choice, {input.settings.tool_radius, leanOf(input.settings)}, strips, plan.part);
        !status.ok())
      return refused(Refusal::Things, status, true);
    plan.cloud = plan.part.cloud ? plan.part.cloud : input.cloud;
    plan.normals = plan.part.cloud ? plan.part.normals : input.normals;
  }
  if (strips.width > 0.0 && plan.part.strips.empty()) // soon: the points are those that were refused
    return refused(Refusal::NoPath, {StatusCode::Failed, "no strip beside a keep-out is that narrow"}, false);
  if (plan.part.cloud)
    clock.end("part");
  if (progress && !progress(0.0, "part"))
    return refused(Refusal::Input, {StatusCode::Cancelled, "cancelled"}, false);
  if (!needsSurface(input, choice, plan))
    return {Status::success()};
  if (input.kept_surface && *input.kept_surface)
    plan.surface = *input.kept_surface;
  else if (const Status status = makeSurface(input, choice, progress, plan); !status.ok())
    return refused(Refusal::NoPath, status, false);
  if (input.kept_surface)
    *input.kept_surface = plan.surface;
  if (plan.mesh)
    keepUsedParts(*plan.surface, *plan.mesh);
  if (!input.holder.empty() && choice.clusters == ClusterHandling::LeaveOut)
    for (const StandingCluster& cluster : plan.surface->clusters())
      for (const pcl::index_t index : cluster.indices)
        plan.echoes.push_back((*plan.cloud)[index].getVector3fMap());
  clock.end("surface");
  return {Status::success()};
}

/** Makes the path. */
AttemptResult
generate(const PlanInput& input, const ProgressCallback& progress, SpiralPlan& plan)
{
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setSettings(plan.settings);
  generator.setSurroundings(surroundingsOf(plan));
  generator.setInputCloud(plan.cloud);
  if (plan.surface)
    generator.setInputSurface(plan.surface);
  else
    generator.setInputNormals(plan.normals);
  if (!plan.mesh && !plan.settings.heights && !plan.part.beside.empty())
    generator.setSurfaceBeyond(surfaceBeyond(*plan.surface, plan.part.beside, plan.settings.tool_radius));
  generator.setPlanner(input.planner);
  for (const std::shared_ptr<const PathModifier>& modifier : input.modifiers)
    generator.addModifier(modifier);
  generator.setQuiet(true);
  generator.setProgressCallback(progress);
  generator.compute(*plan.path);
  plan.report = generator.getReport();
  const Status& status = generator.getStatus();
  if (const std::optional<BlockedWay>& blocked = plan.report.blocked_way; blocked && blocked->by == BlockedBy::KeepOut)
    return {status, Refusal::KeepOut, true, blocked->room, blocked->crosses};
  else if (blocked && blocked->by == BlockedBy::Beside && input.regions.size() > 1)
    return {{status.code(), status.diagnostic() + ". A keep-out holds for all regions: if another region stands there, give each region a "
                                                  "run of its own"},
            Refusal::Things,
            true};
  else if (blocked)
    return {status, Refusal::Things, true};
  if (!status.ok())
    return refused(Refusal::NoPath, plan.mesh ? withSpacings(status, *plan.mesh) : status, madeTurns(plan.report));
  return {status};
}

/** Looks at shank and holder along the path, against the whole scan or mesh; without a holder at nothing. */
AttemptResult
checkHolder(const PlanInput& input, const ProgressCallback& progress, SpiralPlan& plan)
{
  if (input.holder.empty())
    return {Status::success()};
  StageClock clock(plan.report.stages);
  ToolWay way = wayOf(plan);
  way.progress = progress;
  const Status status = checkToolWay(way, ballPasses(*plan.path, plan.settings.tool_radius), plan.report.warnings);
  clock.end("holder");
  return status.ok() ? AttemptResult{status} : refused(Refusal::Things, status, true);
}

} // namespace

AttemptResult
attempt(const PlanInput& input, const PartChoice& choice, const StripChoice& strips, const ProgressCallback& progress, SpiralPlan& plan)
{
  plan.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  std::vector<StageCost> stages;
  StageClock clock(stages);
  if (AttemptResult result = choose(input, choice, strips, progress, clock, plan); !result.status.ok())
    return result;
  plan.settings = settingsFor(input, choice, plan);
  if (AttemptResult result = generate(input, progress, plan); !result.status.ok())
    return result;
  plan.settings.flip_normals = input.settings.flip_normals;
  plan.tool = {CutterShape::ball(plan.settings.tool_radius, input.flank_length), input.holder,          input.holder_clearance,
               gougeTolerance(plan.settings.chord_error, plan.report.noise),     plan.settings.threads, input.accept_collisions};
  if (AttemptResult result = checkHolder(input, progress, plan); !result.status.ok())
    return result;
  SpiralReport& report = plan.report;
  if (plan.mesh)
    for (const Diagnostic& warning : creaseWarnings(*plan.mesh, *plan.surface))
      report.warnings.push_back(warning);
  if (plan.surface)
    report.passes += plan.surface->report().passes;
  report.stages.insert(report.stages.begin(), stages.begin(), stages.end());
  for (const UncutStrip& strip : plan.part.strips)
    report.warnings.push_back(stripText(strip));
  return {Status::success()};
}

} // namespace pcl_spiral
