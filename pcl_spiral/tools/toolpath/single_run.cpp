// SPDX-License-Identifier: BSD-3-Clause
#include "single_run.h"
#include "holder_way.h"
#include "job_failure.h"
#include "mesh_input.h"
#include "path_judging.h"
#include "terminal/scan_places.h"
#include "terminal/vocabulary.h"
#include "way_check.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace pcl_spiral;

namespace {

/** Whether turns were made before the generator of \p report ended. */
bool
madeTurns(const SpiralReport& report)
{
  return std::any_of(report.stages.begin(), report.stages.end(),
                     [](const StageCost& stage) { return stage.name == "step-over field" || stage.name == "radial lines"; });
}

/** \throw NoPath, and what requireOk throws */
void
requirePath(const Job& job, const Status& status, bool is_late = false)
{
  if (status.ok() || status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::Cancelled || cancelled())
    requireOk(job, status);
  else
    throw NoPath(job.scan, status.diagnostic(), is_late);
}

/** The surface of the samples of a mesh, or the one that planning, verification and the map of reach share. */
Surface::ConstPtr
surfaceOf(const Job& job, const Result& result, ProgressBar& bar)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(result.scan.cloud);
  if (result.mesh)
    scanned.setInputNormals(result.mesh->normals);
  else
    setSide(result.side, scanned);
  scanned.setFlipNormals(job.settings.flip_normals && !result.mesh);
  scanned.setLargestPart(job.settings.largest_part);
  scanned.setThinning(result.mesh ? 0.0 : job.settings.thinning);
  if (job.settings.outlier_neighbours > 0 && !result.mesh)
    scanned.setOutlierRemoval(job.settings.outlier_neighbours, job.settings.outlier_deviations);
  if (result.part.part_at)
    scanned.setPartAt(*result.part.part_at);
  scanned.setClusterHandling(job.part.clusters);
  scanned.setNumberOfThreads(job.settings.threads);
  scanned.setQuiet(true);
  scanned.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.25 * share, stage); });
  Surface::ConstPtr surface;
  scanned.compute(surface);
  requirePath(job, scanned.getStatus());
  return surface;
}

/** How far the tool axis leans from the normal, degrees: the tilt asked for, and what smoothing may add. */
double
leanOf(const SpiralSettings& s)
{
  constexpr double most = 60.0; // a shank that leans more would touch the surface itself
  const double asked = std::acos(std::cos(s.tilt_angle * degree) * std::cos(s.lead_angle * degree)) / degree;
  return std::min(most, asked + s.axis_deviation);
}

/** A ball larger than the part may be meant, but a unit that nobody gave is the likelier cause.
 *  \throw FileError if the scan is smaller than the tool radius and --units was not given */
void
requireScale(const Job& job, const Scan& scan)
{
  if (job.given.count("units") > 0)
    return;
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& point : *scan.cloud)
    if (point.getVector3fMap().allFinite())
      box.extend(point.getVector3fMap().cast<double>());
  if (!box.isEmpty() && box.diagonal().norm() < job.settings.tool_radius)
    throw FileError(
        job.scan,
        Diagnostic("the whole scan is ", box.diagonal().norm(), " mm across, less than the tool radius ", job.settings.tool_radius,
                   " mm: ", scanShift().isZero() ? "is the scan in metres or inches?" : "map coordinates are usually in metres or feet.",
                   " Give its unit: --units m or --units inch; or "
                   "--units mm if the ball is larger than the part"));
}

/** Takes the points of the part out of the scan, and makes their surface if more than the planner needs it. */
void
choosePoints(const Job& job, const StripChoice& strips, ProgressBar& bar, StageClock& clock, Result& result)
{
  result.part = choosePart(job.part, job.scan, job.read, {job.settings.tool_radius, leanOf(job.settings)},
                           {result.side, job.settings.flip_normals, job.settings.threads, job.settings.largest_part}, result.scan, strips);
  if (strips.width > 0.0 && result.part.strips.empty())
    throw NoPath(job.scan, "no strip beside a keep-out is that narrow", false); // soon: the points are those that were refused
  if (job.part.cuts())
    result.side = sideOf(result.scan, fromScan(job.settings.view_point));
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  requireScale(job, result.scan);
  // The other parts and the clusters are looked at again when the path is there.
  const bool echoes = !job.holder.empty() && job.part.clusters == ClusterHandling::LeaveOut;
  const bool apart =
      !result.part.beside.empty() || job.part.part_at || job.settings.largest_part || job.part.clusters == ClusterHandling::Ride || echoes;
  if (!job.mesh && job.reach.empty() && job.raw_scan.empty() && !apart && !(job.verify && judgedByTheSameSurface(job.settings)))
    return;
  result.surface = surfaceOf(job, result, bar);
  if (result.mesh)
    keepUsedParts(*result.surface, result);
  for (std::size_t i = 0; echoes && i < result.surface->clusters().size(); ++i)
    for (const pcl::index_t index : result.surface->clusters()[i].indices)
      result.echoes.push_back((*result.scan.cloud)[index].getVector3fMap());
  clock.end("surface");
}

/** The settings for the generator. */
SpiralSettings
settingsFor(const Job& job, const Result& result)
{
  SpiralSettings settings = job.settings;
  settings.part_at = result.part.part_at;
  settings.clusters = job.part.clusters;
  settings.centre = fromScan(settings.centre);
  settings.start_point = fromScan(settings.start_point);
  if (!result.mesh)
    settings.view_point = result.side.view_point;
  settings.hole_size = holeSizeBeside(job.settings.hole_size, result.part.keep_outs, job.settings.tool_radius);
  if (result.mesh) {
    settings.hole_size = meshHoleSize(job, *result.mesh);
    settings.flip_normals = false; // the mesh is turned already
  }
  return settings;
}

} // namespace

void
readInput(const Job& job, ProgressBar& bar, Result& result)
{
  bar.update(0.0, "reading " + job.scan);
  if (job.mesh) {
    speakOfMesh();
    readMeshSamples(job, bar, result);
  }
  else {
    result.scan = readCloud(job.scan, job.read);
    setScanFrame(result.scan.shift, job.read);
    result.side = sideOf(result.scan, fromScan(job.settings.view_point));
  }
  result.whole_scan = result.scan.cloud;
}

Result
planned(const Job& job, const StripChoice& strips, ProgressBar& bar, Result result)
{
  result.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  std::vector<StageCost> stages;
  StageClock clock(stages);
  choosePoints(job, strips, bar, clock, result);
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  result.settings = settingsFor(job, result);
  generator.setSettings(result.settings);
  generator.setSurroundings(surroundingsOf(result));
  generator.setInputCloud(result.scan.cloud);
  if (result.surface)
    generator.setInputSurface(result.surface);
  else
    setSide(result.side, generator);
  if (!result.mesh && !result.part.beside.empty())
    generator.setSurfaceBeyond(surfaceBeyond(*result.surface, result.part.beside, job.settings.tool_radius));
  result.settings.flip_normals = job.settings.flip_normals;
  generator.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  generator.compute(*result.path);
  bar.clear();
  requireFreeWay(job, generator.getStatus(), generator.getReport().blocked_way);
  requirePath(job, result.mesh ? withSpacings(generator.getStatus(), *result.mesh) : generator.getStatus(),
              madeTurns(generator.getReport()));
  result.report = generator.getReport();
  if (!result.mesh)
    for (const Diagnostic& warning : viewPointWarnings(result.side, result.report.side))
      result.report.warnings.push_back(warning);
  checkRawScan(job, result);
  checkHolder(job, result);
  if (result.mesh)
    for (const Diagnostic& warning : creaseWarnings(*result.mesh, *result.surface))
      result.report.warnings.push_back(warning);
  if (result.surface)
    result.report.passes += result.surface->counts().passes;
  result.report.stages.insert(result.report.stages.begin(), stages.begin(), stages.end());
  for (const UncutStrip& strip : result.part.strips)
    result.report.warnings.push_back(stripText(strip));
  return result;
}
