// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"

#include "passes/pass_scan.h"
#include "program/program_check.h"
#include "terminal/failure.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/planning/ridge_planner.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

using Planner = RidgePlanner<pcl::PointXYZ>;

constexpr double for_pictures = 1e-3; // of the width of a ridge: chord error of its triangles

Polyline
readLine(const Job& job, const std::string& file, bool first, Diagnostics& warnings)
{
  const Scan read = readCloud(file, first ? job.read : readAsScan(job.read)); // the files after it are read in its coordinates
  if (first)
    setScanFrame(read.shift, job.read);
  for (const Diagnostic& warning : read.warnings) {
    const std::vector<std::string> settings = warning.settings();
    if (file == job.rail || std::count(settings.begin(), settings.end(), "ReadOptions::unit") == 0) // a generator is usually small
      warnings.push_back(warning);
  }
  Polyline points;
  for (const pcl::PointXYZ& p : *read.cloud)
    points.push_back(p.getVector3fMap().cast<double>());
  return points;
}

void
setLines(const Job& job, Planner& planner, Diagnostics& warnings)
{
  Polyline through;
  for (const Eigen::Vector3d& place : job.through)
    through.push_back(fromScan(place));
  planner.setRoughPoints(through);
  planner.setClosed(job.ring);
  planner.setHalfWidth(job.half_width);
  if (!job.through.empty())
    return;
  const Polyline rail = readLine(job, job.rail, job.scan.empty(), warnings);
  planner.setMeasuredLines(rail, readLine(job, job.generator, false, warnings));
}

void
setTool(const Job& job, Planner& planner)
{
  PassSettings tool = job;
  tool.accept_collisions = job.program.accept_collisions;
  planner.setPassSettings(tool);
  planner.setRidgeSettings(job.ridge);
  planner.setRowSettings(job.rows);
  planner.setSampleMesh(hasLeads(job.program, job.outputs));
  planner.setNumberOfThreads(job.threads);
}

/** The name of the input where a plan failed. */
std::string
fileOf(const Job& job, RidgeFault fault)
{
  return fault == RidgeFault::Scan ? job.scan : fault == RidgeFault::Lines ? job.rail + ", " + job.generator : job.part;
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  Result result;
  std::vector<StageCost> stages;
  StageClock clock(stages);
  Planner planner;
  bar.update(0.0, "reading " + (job.scan.empty() ? job.rail : job.scan));
  if (!job.scan.empty())
    readPassScan(job, planner, result);
  setLines(job, planner, result.warnings);
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  setTool(job, planner);
  planner.setQuiet(true);
  planner.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  planner.compute();
  bar.clear();
  require(fileOf(job, planner.getPlan().fault), planner.getStatus());
  const Diagnostics reading = std::move(result.warnings);
  static_cast<PassPlan&>(result) = planner.getPlan();
  static_cast<RidgePlanReport&>(result) = planner.getPlan();
  const bool pictures = std::any_of(job.outputs.begin(), job.outputs.end(),
                                    [](const std::string& o) { return extensionOf(o) == ".png" || extensionOf(o) == ".html"; });
  if (pictures && !job.hasCutter())
    require(job.part, makeRidgeMesh(*result.ridge, for_pictures * result.ridge->generator().length(), result.mesh));
  result.warnings.insert(result.warnings.begin(), reading.begin(), reading.end());
  result.stages.insert(result.stages.begin(), stages.begin(), stages.end());
  if (!job.hasCutter() && hasLeads(job.program, job.outputs))
    result.warnings.push_back("the motion of the beam's head is not checked because its shape is not known; check that it is free");
  return result;
}
