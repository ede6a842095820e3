// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"
#include "column_ends.h"
#include "joined_drives.h"
#include "judging/raw_scan_option.h"
#include "mesh_part.h"
#include "passes/cutter_locations.h"
#include "passes/free_passes.h"
#include "passes/left_out.h"
#include "passes/mesh_samples.h"
#include "passes/pass_axes.h"
#include "passes/scan_surface.h"
#include "program/program_check.h"
#include "scallop_check.h"
#include "terminal/region_choice.h"
#include "terminal/terminal.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/surface/impl/side_text.h>

using namespace pcl_spiral;

namespace {

Polyline
curveOf(const Job& job, Result& result)
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
  result.warnings.insert(result.warnings.end(), curve.warnings.begin(), curve.warnings.end());
  return points;
}

DrivePasses
drivePasses(const Job& job, const Surface::ConstPtr& surface, ProgressBar& bar, Result& result)
{
  DrivePath<pcl::PointXYZ> drive;
  const DriveSettings& s = job.drive;
  setPart(job, result, surface, drive);
  drive.setKind(s.kind);
  drive.setStepOver(s.step_over);
  drive.setPointSpacing(s.point_spacing);
  drive.setPlaneDirection(s.plane_angle);
  drive.setZigzag(s.zigzag);
  drive.setRows(s.rows);
  drive.setScallop(job.cutter, job.scallop);
  drive.setLinkRows(s.link_rows);
  drive.setAxis(s.axis);
  drive.setAxisMode(s.axisMode());
  drive.setOverrun(s.overrun);
  if (job.column_axis)
    drive.setCylinder({fromScan(job.column_centre), *job.column_axis});
  if (s.kind == DriveKind::Curve)
    drive.setCurve(curveOf(job, result));
  drive.setChordError(0.5 * job.tolerance); // the other half is for the moves between locations
  drive.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.5 * share, stage); });
  DrivePasses passes;
  drive.compute(passes);
  require(job.scan, drive.getStatus());
  result.drive = drive.getReport();
  smoothPasses(job, passes, result.warnings);
  return passes;
}

/** Warns of a side that is not clear, if the axes depend on it. */
void
warnOfSide(const Job& job, Result& result)
{
  if (const DriveAxisMode mode = job.drive.axisMode(); mode == DriveAxisMode::Surface || mode == DriveAxisMode::LocalPlane) {
    for (Diagnostic& warning : sideWarnings(result.side))
      result.warnings.push_back(std::move(warning));
    for (Diagnostic& warning : viewPointWarnings(result.asked_side, result.side))
      result.warnings.push_back(std::move(warning));
  }
}

/** Adds the warnings: those of the scan in front, then those of the drive path and of the locations. */
void
warnOfPath(const Job& job, Result& result)
{
  Diagnostics& warnings = result.warnings;
  warnings.insert(warnings.begin(), result.scan.warnings.begin(), result.scan.warnings.end());
  warnings.insert(warnings.end(), result.drive.warnings.begin(), result.drive.warnings.end());
  warnOfLocations(job, result);
  if (job.no_gouge_check)
    warnings.push_back("the cutter was not checked against the rest of the mesh (--no-gouge-check): it gouges hollows narrower "
                       "than itself");
}

/** The passes over the region that job.choice chooses. */
Result
planned(const Job& job, ProgressBar& bar)
{
  Result result;
  StageClock clock(result.stages);
  Surface::ConstPtr& surface = result.surface;
  if (job.mesh) {
    bar.update(0.0, "reading " + job.scan);
    readMeshPart(job, result);
    clock.end("mesh");
    if (hasLeads(job.program, job.outputs) || job.drive.goesRound()) {
      sampleMesh(job, result);
      clock.end("samples");
    }
  }
  else {
    surface = heedClusters(job, bar, readScan(job, bar, result, clock), result);
    warnOfSide(job, result);
  }
  if (!job.raw_scan.empty() && surface)
    result.warnings.push_back(Diagnostic(smoothingText(rawScanFigures(job.raw_scan, job.read, *surface), job.raw_scan),
                                         "; pcl_spiral_verify --raw-scan judges the path by it"));
  const DrivePasses passes = drivePasses(job, surface, bar, result);
  clock.end("drive path");
  std::vector<ToolLocations> located = job.no_gouge_check ? standAtContacts(job, passes) : locateCutter(job, surface, passes, bar, result);
  clock.end("locations");
  bar.clear();
  leaveOut(job, located, result);
  requireNoCollision(job, located);
  requireKnownEnd(job, located);
  takePoses(located, result);
  if (result.passes.empty())
    throw FileError(job.scan, "no pass has two cutter locations over the part; check the drive path and the tool axis");
  requireFreePasses(job, result);
  if (job.drive.goesRound())
    warnOfEnds(job, located, result);
  requireScallop(job, surface, result);
  warnOfPath(job, result);
  clock.end("scallop check");
  return result;
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  std::vector<Result> regions;
  for (const NamedRegion& region : regionsOf(job.choice, job.regions, job.read)) {
    Job one = job;
    one.choice = region.part;
    regions.push_back(inRegion(region.name, [&] { return planned(one, bar); }));
    regions.back().region = region.name;
  }
  return regions.size() == 1 ? std::move(regions.front()) : joined(job, std::move(regions));
}
