// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/path_judging.h>

#include "planning/part_selection.h"
#include "planning/plan_regions.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

/** The part of the scan, and what is around it. */
Status
choose(const JudgedInput& input, JudgeSettings& settings, pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud, JudgedSurroundings& around)
{
  if (settings.mesh && input.raw)
    return {StatusCode::InvalidArgument, "{setRawScan} belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out"};
  if (settings.mesh)
    return checkPartOfMesh(input.choice, input.regions);
  if (input.regions.size() > 1)
    return {StatusCode::InvalidArgument, Diagnostic(input.regions.size(), " regions are given ({addRegion}), and a path is judged by one: "
                                                                          "judge the passes of each region by its own")};
  const PartChoice choice = choiceOf(input.choice, namedRegions(input.regions).front());
  PartTool tool{settings.cutter.radius, 0.0};
  if (!choice.keep_outs.empty())
    tool.lean = leanOf(*input.path); // as that of the path, so that points near keep-outs are left to it
  ChosenPart part;
  if (const Status status = choosePart({input.cloud, input.normals, input.surface, input.indices}, choice, tool, {}, part); !status.ok())
    return status;
  cloud = part.cloud ? part.cloud : input.cloud;
  settings.normals = part.cloud ? part.normals : input.normals;
  settings.part_at = choice.part_at;
  settings.clusters = choice.clusters;
  around = {part.keep_outs, part.kept_out, part.beside, input.cloud};
  return Status::success();
}

} // namespace

Status
compareRawScan(const pcl::PointCloud<pcl::PointXYZ>& raw, const Surface& smoothed, RawScanFigures& figures)
{
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : raw)
    points.push_back(p.getVector3fMap());
  if (points.empty())
    return {StatusCode::InvalidInput, "the raw scan has no points"};
  figures = compareWithRaw(smoothed, points);
  if (2 * figures.points >= std::min(points.size(), smoothed.size())) // the surface may be of one region of the raw scan
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic(points.size() - figures.points, " of ", points.size(),
                                               " points of this raw scan have no smoothed surface near: is it another part, another "
                                               "unit, or are its columns others?")};
}

Status
verifyPath(const JudgedInput& input, std::shared_ptr<const ReferenceSurface>& reference, Verification& verification, Heights& heights)
{
  if (!input.path || input.path->empty())
    return {StatusCode::InvalidInput, "the path is missing or empty: call {setInputToolpath} with points"};
  if (!(input.settings.cutter.radius > 0.0))
    return {StatusCode::InvalidArgument, "the cutter is missing: call {setCutter}, such as with CutterShape::ball(6.0)"};
  if (input.surface.thinning > 0.0 || input.surface.outlier_neighbours > 0)
    return {StatusCode::InvalidArgument, Diagnostic(input.surface.thinning > 0.0 ? "{setThinning}" : "{setOutlierRemoval}",
                                                    " was called, but a path is judged by all points of the scan: leave it out")};
  JudgeSettings settings = input.settings;
  settings.view_point = input.surface.view_point;
  settings.trust_normals = input.surface.trust_normals;
  settings.flip_normals = input.surface.flip_normals;
  settings.threads = input.surface.threads;
  settings.largest_part = input.surface.largest_part && !input.surface.part_at;
  JudgedSurroundings around;
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  if (const Status status = choose(input, settings, cloud, around); !status.ok())
    return status;
  const ProgressCallback progress = input.progress ? input.progress : [](double, const std::string&) { return true; };
  if (const Status status = judgePath(cloud, input.path, settings, progress, reference, verification, heights); !status.ok())
    return status;
  RawScanFigures raw;
  if (input.raw)
    if (const Status status = compareRawScan(*input.raw, reference->scanned(), raw); !status.ok())
      return status;
  addVerdicts(input.limits, around, *reference, input.path, settings, input.raw ? &raw : nullptr, "the raw scan", verification);
  return Status::success();
}

} // namespace pcl_spiral
