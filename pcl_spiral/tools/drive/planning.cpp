// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"
#include "judging/raw_scan_option.h"
#include "passes/pass_scan.h"
#include "program/program_check.h"
#include "terminal/failure.h"
#include "terminal/region_choice.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/planning/drive_planner.h>

#include <Eigen/Geometry>

using namespace pcl_spiral;

namespace {

using Planner = DrivePlanner<pcl::PointXYZ>;

Polyline
curveOf(const Job& job, Diagnostics& warnings)
{
  ReadOptions read = readAsScan(job.read);
  read.columns.clear();
  read.skip_lines = 0;
  const Scan curve = readCloud(job.curve_file, read);
  Polyline points;
  for (const pcl::PointXYZ& p : *curve.cloud)
    points.push_back(p.getVector3fMap().cast<double>());
  if (points.size() < 2)
    throw FileError(job.curve_file, "a curve needs at least two points; add points, or give another file");
  warnings.insert(warnings.end(), curve.warnings.begin(), curve.warnings.end());
  return points;
}

/** A part smaller than the cutter is probably in another unit. */
void
requireLargerThanCutter(const Job& job, const SurfaceMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    box.extend(mesh.position(v));
  if (box.diagonal().norm() < job.cutter.radius)
    throw FileError(job.scan, Diagnostic("the mesh, from ", Place(box.min()), " to ", Place(box.max()),
                                         ", is smaller than the cutter's radius of ", job.cutter.radius,
                                         " mm: is it in another unit? Give the unit, such as --units m, or a smaller --tool-radius"));
}

void
readMeshPart(const Job& job, Planner& planner, Result& result)
{
  const MeshFile file = readMesh(job.scan, job.read);
  setScanFrame(file.shift, job.read);
  result.warnings = file.warnings;
  SurfaceMesh::ConstPtr mesh;
  require(job.scan, SurfaceMesh::make(*file.mesh, job.mesh_settings, mesh));
  requireLargerThanCutter(job, *mesh);
  planner.setInputMesh(mesh);
  planner.setSampleMesh(hasLeads(job.program, job.outputs));
  planner.setGougeCheck(!job.no_gouge_check);
}

void
readScanPart(const Job& job, Planner& planner, Result& result)
{
  readPassScan(job, planner, result);
  planner.setFlipNormals(job.flip_scan);
  planner.setClusterHandling(job.choice.clusters);
  setPart(job.choice, job.regions, job.read, planner);
}

/** Tool and drive path. */
void
setPasses(const Job& job, Planner& planner, Diagnostics& warnings)
{
  DriveSettings drive = job.drive;
  if (job.column_axis)
    drive.cylinder = DriveCylinder{fromScan(job.column_centre), *job.column_axis};
  if (drive.kind == DriveKind::Curve)
    drive.curve = curveOf(job, warnings);
  planner.setSettings(drive);
  planner.setCutter(job.cutter);
  planner.setPassSettings(job);
  planner.setHolder(job.holder);
  planner.setHolderClearance(job.holder_clearance);
  planner.setAcceptCollisions(job.program.accept_collisions);
  planner.setNumberOfThreads(job.threads);
}

/** What the program alone knows of a region with that \p side and \p surface. */
Diagnostics
warningsOf(const Job& job, const ScanSide& asked_side, const OuterSide& side, const Surface::ConstPtr& surface)
{
  Diagnostics warnings;
  if (const DriveAxisMode mode = job.drive.axisMode(); mode == DriveAxisMode::Surface || mode == DriveAxisMode::LocalPlane)
    warnings = viewPointWarnings(asked_side, side);
  if (!job.raw_scan.empty() && surface)
    warnings.push_back(Diagnostic(smoothingText(rawScanFigures(job.raw_scan, job.read, *surface), job.raw_scan),
                                  "; pcl_spiral_verify --raw-scan judges the path by it"));
  return warnings;
}

void
addWarnings(const Job& job, Result& result)
{
  if (result.mesh)
    return;
  const auto add = [&](const std::string& name, const OuterSide& side, const Surface::ConstPtr& surface) {
    for (const Diagnostic& warning : inRegion(name, [&] { return warningsOf(job, result.asked_side, side, surface); }))
      result.warnings.push_back(name.empty() ? warning : Diagnostic(name, ": ", warning));
  };
  if (result.regions.empty())
    add("", result.side, result.surface);
  for (const PlannedRegion& region : result.regions)
    add(region.name, region.side, region.surface);
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
  Planner planner;
  if (job.mesh)
    readMeshPart(job, planner, result);
  else
    readScanPart(job, planner, result);
  if (cancelled())
    throw Cancelled();
  setPasses(job, planner, result.warnings);
  planner.setQuiet(true);
  planner.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  clock.end(job.mesh ? "mesh" : "reading");
  planner.compute();
  bar.clear();
  require(job.scan, planner.getStatus());
  const Diagnostics reading = std::move(result.warnings);
  static_cast<PassPlan&>(result) = planner.getPlan();
  result.warnings.insert(result.warnings.begin(), result.chosen.warnings.begin(), result.chosen.warnings.end());
  result.warnings.insert(result.warnings.begin(), reading.begin(), reading.end());
  result.stages.insert(result.stages.begin(), stages.begin(), stages.end());
  addWarnings(job, result);
  return result;
}
