// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"
#include "path_judging.h"
#include "path_program.h"
#include "program/program_check.h"
#include "terminal/failure.h"
#include "terminal/file_names.h"
#include "terminal/idle_options.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include "judging/raw_scan_option.h"
#include "planning/joined_plan.h"
#include "planning/plan_regions.h"
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** A ball larger than the part may be meant, but a unit that nobody gave is the likelier cause.
 *  \throw FileError if what is in \p box is smaller than the tool radius and --units was not given */
void
requireScale(const Job& job, const Eigen::AlignedBox3d& box)
{
  if (job.given.count("units") > 0 || box.isEmpty() || box.diagonal().norm() >= job.settings.tool_radius)
    return;
  throw FileError(
      job.scan,
      Diagnostic("the whole scan is ", box.diagonal().norm(), " mm across, less than the tool radius ", job.settings.tool_radius,
                 " mm: ", scanShift().isZero() ? "is the scan in metres or inches?" : "map coordinates are usually in metres or feet.",
                 " Give its unit: --units m or --units inch; or --units mm if the ball is larger than the part"));
}

Eigen::AlignedBox3d
boxOf(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite(point))
      box.extend(point.getVector3fMap().cast<double>());
  return box;
}

void
readScan(const Job& job, SpiralPlanner<pcl::PointXYZ>& planner, Result& result)
{
  Scan scan = readCloud(job.scan, job.read);
  setScanFrame(scan.shift, job.read);
  requireScale(job, boxOf(*scan.cloud));
  result.reading = std::move(scan.warnings);
  result.side = sideOf(scan, fromScan(job.settings.view_point));
  planner.setInputCloud(scan.cloud);
  planner.setInputNormals(result.side.normals);
}

void
readFaces(const Job& job, SpiralPlanner<pcl::PointXYZ>& planner, Result& result)
{
  speakOfMesh();
  MeshFile file = readMesh(job.scan, job.read);
  setScanFrame(file.shift, job.read);
  result.reading = std::move(file.warnings);
  MeshSettings settings;
  settings.flip = job.settings.flip_normals;
  SurfaceMesh::ConstPtr mesh;
  require(job.scan, SurfaceMesh::make(*file.mesh, settings, mesh));
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh->vertexCount(); ++v)
    box.extend(mesh->position(v));
  requireScale(job, box);
  planner.setInputMesh(mesh);
  planner.setSampleSpacing(job.sample_spacing);
}

/** The settings, in the coordinates of the scan that was read. */
SpiralSettings
settingsOf(const Job& job, const Result& result)
{
  SpiralSettings settings = job.settings;
  settings.trust_normals = false; // they come from a file: normals without a common side are not used, with a warning
  settings.flip_normals = job.settings.flip_normals && !job.mesh; // the mesh is turned already
  settings.clusters = job.part.clusters;
  settings.centre = fromScan(settings.centre);
  settings.start_point = fromScan(settings.start_point);
  settings.view_point = result.side.view_point;
  return settings;
}

/** Whether a report shows the surface. */
bool
writesPage(const std::vector<std::string>& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(), [](const std::string& output) { return extensionOf(output) == ".html"; });
}

void
setHolder(const Job& job, SpiralPlanner<pcl::PointXYZ>& planner)
{
  planner.setFlankLength(job.flank_length);
  planner.setBallClosing(job.ball_closing);
  planner.setRemedyTries(job.remedy_tries);
  planner.setAskedNames(askedNames(job.given));
  planner.setHolder(job.holder);
  planner.setHolderClearance(job.holder_clearance);
  planner.setAcceptCollisions(job.program.accept_collisions);
  planner.setKeepSurface(!job.reach.empty() || !job.raw_scan.empty() || writesPage(job.outputs) ||
                         (job.verify && judgedByTheSameSurface(job.settings)));
}

/** Says what smoothing moved, if there is a raw scan, and warns where the ball cuts into its points.
 *  \throw FileError if it does and the path is judged (--verify); if the raw scan cannot be read */
Diagnostics
rawScanWarnings(const Job& job, const SpiralPlan& plan)
{
  if (job.raw_scan.empty())
    return {};
  const RawScanReport raw = rawScanFigures(job.raw_scan, job.read, *plan.surface);
  JudgeSettings settings;
  settings.cutter = CutterShape::ball(job.settings.tool_radius);
  const double allowed = job.limits.gouge.value_or(gougeTolerance(job.settings.chord_error, plan.report.noise));
  const Diagnostic fault = faultInRaw(raw, plan.path, settings, allowed);
  if (fault.empty())
    return {smoothingText(raw, job.raw_scan)};
  if (job.verify)
    throw FileError(job.scan, Diagnostic("the path was made, but ", fault));
  return {smoothingText(raw, job.raw_scan), fault};
}

/** Adds what the program alone knows of the regions of \p plan. */
void
addWarnings(const Job& job, const ScanSide& side, SpiralPlan& plan)
{
  const auto add = [&](SpiralPlan& region) {
    Diagnostics warnings;
    if (!region.mesh)
      warnings = viewPointWarnings(side, region.report.side);
    for (const Diagnostic& warning : rawScanWarnings(job, region))
      warnings.push_back(warning);
    region.report.warnings.insert(region.report.warnings.end(), warnings.begin(), warnings.end());
    return warnings;
  };
  if (plan.regions.empty())
    add(plan);
  for (SpiralPlan& region : plan.regions)
    for (const Diagnostic& warning : ofRegion(region.region, inRegion(region.region, [&] { return add(region); })))
      plan.report.warnings.push_back(warning);
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  Result result;
  std::vector<StageCost> stages;
  StageClock clock(stages);
  bar.update(0.0, "reading " + job.scan);
  SpiralPlanner<pcl::PointXYZ> planner;
  if (job.mesh)
    readFaces(job, planner, result);
  else
    readScan(job, planner, result);
  if (cancelled())
    throw Cancelled();
  planner.setSettings(settingsOf(job, result));
  setPart(job.part, job.regions, job.read, planner);
  setHolder(job, planner);
  planner.setQuiet(true);
  planner.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  clock.end("reading");
  planner.compute();
  bar.clear();
  require(job.scan, planner.getStatus());
  result.plan = planner.getPlan();
  result.regions.resize(result.plan.regions.size());
  result.plan.settings.flip_normals = job.settings.flip_normals;
  addWarnings(job, result.side, result.plan);
  addStage(stages.front(), result.plan.report.stages);
  if (!result.plan.regions.empty() && !hasProgram(job.program, job.outputs)) // the leads of a program are checked when it is there
    checkLinks(job, result);
  return result;
}
