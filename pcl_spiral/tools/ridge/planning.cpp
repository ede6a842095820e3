// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"

#include "passes/pass_axes.h"
#include "program/program_check.h"
#include "terminal/failure.h"
#include "terminal/file_names.h"

#include "drive/pass_axes.h"
#include "planning/part_surface.h"
#include "planning/pass_locations.h"
#include "planning/pass_mesh.h"
#include "planning/tool_way.h"
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <algorithm>
#include <cmath>

using namespace pcl_spiral;

namespace {

Polyline
readLine(const Job& job, const std::string& file, Result& result)
{
  const bool first = job.scan.empty() && result.rail.empty(); // the files after it are read in its coordinates
  const Scan read = readCloud(file, first ? job.read : readAsScan(job.read));
  if (first)
    setScanFrame(read.shift, job.read);
  for (const Diagnostic& warning : read.warnings) {
    const std::vector<std::string> settings = warning.settings();
    if (file == job.rail || std::count(settings.begin(), settings.end(), "ReadOptions::unit") == 0) // a generator is usually small
      result.warnings.push_back(warning);
  }
  Polyline points;
  for (const pcl::PointXYZ& p : *read.cloud)
    points.push_back(p.getVector3fMap().cast<double>());
  return points;
}

void
readLines(const Job& job, Result& result)
{
  result.rail = readLine(job, job.rail, result);
  result.generator = readLine(job, job.generator, result);
  require(job.rail + ", " + job.generator, RidgeSurface::make(result.rail, result.generator, job.ridge, result.ridge));
  const Diagnostics& warnings = result.ridge->report().warnings;
  result.warnings.insert(result.warnings.end(), warnings.begin(), warnings.end());
}

void
findLines(const Job& job, ProgressBar& bar, Result& result)
{
  RidgeLines<pcl::PointXYZ> lines;
  lines.setInputCloud(result.cloud); // not the cutter's surface: its side may differ
  lines.setLargestPart(job.largest_part);
  lines.setThinning(job.thinning);
  lines.setNumberOfThreads(job.threads);
  Polyline through;
  for (const Eigen::Vector3d& place : job.through)
    through.push_back(fromScan(place));
  lines.setRoughPoints(through);
  lines.setClosed(job.ring);
  lines.setHalfWidth(job.half_width);
  lines.setReferenceNormal(job.ridge.reference);
  lines.setFlipNormals(job.ridge.flip);
  lines.setQuiet(true);
  lines.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.3 + 0.4 * share, stage); });
  pcl::PointCloud<pcl::PointXYZ> rail, generator;
  lines.compute(rail, generator);
  require(job.scan, lines.getStatus());
  result.rail = lines.getRail();
  result.generator = lines.getGenerator();
  result.ridge = lines.getRidge();
  result.found = lines.getReport();
  result.warnings.insert(result.warnings.end(), result.found->warnings.begin(), result.found->warnings.end());
}

DrivePasses
makeRows(const Job& job, Result& result)
{
  DrivePasses rows;
  const ThreadLimit limit(job.threads);
  require(job.part, planRidgeRows(*result.ridge, job.rows, rows, result.rows));
  result.warnings.insert(result.warnings.end(), result.rows.warnings.begin(), result.rows.warnings.end());
  smoothPasses(job, rows, result.warnings, job.hasCutter() ? std::nullopt : std::optional(job.rows.stand_off));
  return rows;
}

/** A beam at the places of the rows; its spot is below them on the surface. */
void
takeBeam(const Job& job, const DrivePasses& rows, Result& result)
{
  result.passes = beamPasses(rows, job.rows.stand_off);
  for (const ToolPoses& poses : result.passes)
    for (std::size_t i = 1; i < poses.size(); ++i)
      result.length += (poses[i].tip - poses[i - 1].tip).norm();
  const double lean = std::hypot(job.rows.lead, job.rows.tilt);
  if (lean > 0.0 && job.rows.stand_off != 0.0)
    result.warnings.push_back(
        Diagnostic("the beam is tilted by about ", lean, " degrees at a stand-off of ", job.rows.stand_off,
                   " mm: it meets the surface about ", std::abs(job.rows.stand_off) * std::tan(lean * pi / 180.0),
                   " mm beside the row, at the contacts in the files; to have the tip at the spot, leave --stand-off out and add the "
                   "stand-off to the tool length"));
  if (hasLeads(job.program, job.outputs))
    result.warnings.push_back("the motion of the beam's head is not checked because its shape is not known; check that it is free");
}

/** Triangles of the ridge. Their faces are curved: at a chord error of a ten thousandth of the width, the surface behind them is a hundred
 *  times nearer (measured: 1e-5 mm on a ridge 27 mm wide), far below a cutter's tolerance. */
void
makeMesh(const Job& job, Result& result)
{
  constexpr double share_of_tolerance = 0.2, finest = 1e-4, for_pictures = 1e-3;
  const double width = result.ridge->generator().length();
  const double chord_error = job.hasCutter() ? std::max(share_of_tolerance * job.tolerance, finest * width) : for_pictures * width;
  if (const Status status = ridgeMesh(*result.ridge, chord_error, result.mesh); !status.ok())
    throw FileError(job.part, Diagnostic("a ridge ", result.ridge->rail().length(), " mm long and ", width,
                                         " mm wide needs too many triangles, more than a million: machine it in pieces"));
}

SurfaceSettings
surfaceSettings(const Job& job, const Result& result)
{
  SurfaceSettings settings;
  settings.trust_normals = false; // they come from a file: normals without a common side are not used, with a warning
  settings.view_point = result.asked_side.view_point;
  settings.flip_normals = job.flip_scan;
  settings.largest_part = job.largest_part;
  settings.thinning = job.thinning;
  settings.threads = job.threads;
  return settings;
}

/** The scan, without its outliers if asked for, and the surface through its points; null if they form none. */
void
readScan(const Job& job, ProgressBar& bar, StageClock& clock, Result& result)
{
  bar.update(0.0, "reading " + job.scan);
  const Scan scan = readCloud(job.scan, job.read);
  setScanFrame(scan.shift, job.read);
  result.warnings = scan.warnings;
  result.whole = result.cloud = scan.cloud;
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  result.asked_side = sideOf(scan, fromScan(job.view_point));
  result.normals = result.asked_side.normals;
  if (job.leave_out_strays) {
    bar.update(0.0, "strays");
    require(job.scan, leaveOutStrays(job.threads, result));
    clock.end("strays");
  }
  const auto progress = [&bar](double share, const std::string& stage) { return bar.update(0.3 * share, stage); };
  require(job.scan, makePartSurface(surfaceSettings(job, result), progress, result));
  clock.end("surface");
}

void
takeCutter(const Job& job, const DrivePasses& rows, ProgressBar& bar, Result& result)
{
  PassSettings tool = job;
  tool.accept_collisions = job.program.accept_collisions;
  std::vector<ToolLocations> located;
  const auto progress = [&bar](double share, const std::string& stage) { return bar.update(0.5 + 0.5 * share, stage); };
  require(job.part, locateCutter(tool, surfaceSettings(job, result), rows, progress, result, located));
  result.tool = toolOf(tool, result);
  require(job.part, checkCollisions(tool, located));
  require(job.part, checkEnd(tool, located));
  takePoses(located, result);
  if (result.passes.empty())
    throw FileError(job.scan, "no row has two cutter locations over the part: check that lines and scan are in the same coordinates");
  if (!job.holder.empty())
    require(job.part, checkToolWay(wayOf(result), result.passes, result.warnings));
  warnOfLocations(tool, result);
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  Result result;
  StageClock clock(result.stages);
  if (!job.scan.empty())
    readScan(job, bar, clock, result);
  if (job.through.empty())
    readLines(job, result);
  else
    findLines(job, bar, result);
  clock.end("lines");
  const DrivePasses rows = makeRows(job, result);
  clock.end("rows");
  const bool pictures = std::any_of(job.outputs.begin(), job.outputs.end(), [](const std::string& o) { return extensionOf(o) == ".png"; });
  if (job.hasCutter() ? job.scan.empty() : pictures) {
    makeMesh(job, result);
    clock.end("mesh");
  }
  if (job.hasCutter()) {
    if (job.scan.empty() && hasLeads(job.program, job.outputs))
      require(job.part, sampleMesh(job.cutter.radius, job.threads, result));
    takeCutter(job, rows, bar, result);
    clock.end("locations");
  }
  else
    takeBeam(job, rows, result);
  bar.clear();
  return result;
}
