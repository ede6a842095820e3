// SPDX-License-Identifier: BSD-3-Clause
#include "scallop_check.h"
#include "passes/scan_surface.h"

#include "cutter/swept_heights.h"
#include "cutter/tool_body.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/mesh/mesh_sampling.h>

#include <algorithm>
#include <cstddef>

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr std::size_t most_places = 6000;
constexpr double ignored_share = 0.02; // of the surface: steep rims, creases

struct CutPlace {
  Vector3d x, normal;
};

std::vector<CutPlace>
scanPlaces(const Surface& surface)
{
  std::vector<Vector3d> points;
  const std::size_t every = 1 + surface.size() / most_places;
  for (std::size_t i = 0; i < surface.size(); i += every)
    points.push_back(surface.graph().position(i));
  std::vector<SurfaceFoot> feet;
  surface.fit().project(points, feet);
  std::vector<CutPlace> places;
  for (const SurfaceFoot& foot : feet)
    if (foot.valid)
      places.push_back({foot.position, foot.normal});
  return places;
}

std::vector<CutPlace>
meshPlaces(const Job& job, const SurfaceMesh::ConstPtr& mesh)
{
  MeshSampling sampling;
  sampling.setInputMesh(mesh);
  sampling.setNumberOfThreads(job.threads);
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  require(job.part, sampling.getStatus());
  std::vector<CutPlace> places;
  const std::size_t every = 1 + samples.size() / most_places;
  for (std::size_t i = 0; i < samples.size(); i += every)
    places.push_back({samples[i].getVector3fMap().cast<double>(), samples[i].getNormalVector3fMap().cast<double>()});
  return places;
}

/** Places that the path is meant to cut: of a column, those between its first and last contact. */
std::vector<CutPlace>
meantPlaces(const Job& job, const Surface::ConstPtr& surface, const Result& result)
{
  std::vector<CutPlace> places = result.mesh ? meshPlaces(job, result.mesh) : scanPlaces(*surface);
  if (!job.drive.goesRound())
    return places;
  const Vector3d& up = result.drive.column->cylinder.direction;
  double low = 1e300, high = -1e300;
  for (const ToolPoses& pass : result.passes)
    for (const ToolPose& pose : pass) {
      low = std::min(low, up.dot(pose.contact));
      high = std::max(high, up.dot(pose.contact));
    }
  const auto isBeyond = [&](const CutPlace& place) { return up.dot(place.x) < low || up.dot(place.x) > high; };
  places.erase(std::remove_if(places.begin(), places.end(), isBeyond), places.end());
  return places;
}

/** What is left over each place: the height along its normal, or, where that is more than asked for, the distance from what is cut, which
 *  is less in a corner; twice the radius of the cutter if nothing is cut below that height. */
std::vector<double>
leftOver(const std::vector<CutPlace>& places, const Job& job, const Result& result)
{
  std::vector<std::vector<CutterPlace>> passes;
  for (const ToolPoses& pass : result.passes) {
    passes.emplace_back();
    for (const ToolPose& pose : pass)
      passes.back().push_back({pose.tip, pose.axis});
  }
  const double nothing = 2.0 * job.cutter.radius;
  const CutterProfile cutter(job.cutter);
  const SweptHeights swept(cutter, toolLength(cutter, job.holder), passes);
  std::vector<double> left(places.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(places.size()); ++i) {
    left[i] = swept.over(places[i].x, places[i].normal, nothing);
    if (left[i] > job.scallop && left[i] < nothing && job.cutter.corner_radius > 0.0) // a sharp edge leaves steps as high
      left[i] = swept.distance(places[i].x, left[i]);
  }
  return left;
}

Diagnostic
remedyOf(const Job& job, const Result& result, double height)
{
  const bool can_keep = job.drive.kind == DriveKind::Planes && job.drive.rows == DriveRows::Even && !job.mesh &&
                        job.drive.axisMode() != DriveAxisMode::Cylinder;
  const Diagnostic higher =
      more_left * height < job.cutter.radius ? Diagnostic(", ask for --scallop ", more_left * height) : ""; // else refused
  return Diagnostic(can_keep ? "use --rows kept" : "take a cutter with a smaller radius", higher, ", or give --step-over ",
                    result.drive.step_over, " instead, which promises no height");
}

/** Whether rows are even or kept over all of a scan, and nothing else says what they leave out. */
bool
isWholeScanMeant(const Job& job, const Result& result)
{
  return job.drive.kind == DriveKind::Planes && job.drive.axisMode() == DriveAxisMode::Fixed && !result.mesh &&
         result.chosen.keep_outs.empty() && result.drive.step_over <= job.cutter.radius;
}

/** How much of the surface a fixed axis does not reach; empty if no more than rims. */
Diagnostic
uncutText(const Job& job, const std::vector<CutPlace>& places, const std::vector<double>& left, const Result& result)
{
  const auto isUncut = [&](double height) { return height >= 2.0 * job.cutter.radius; };
  const auto first = std::find_if(left.begin(), left.end(), isUncut);
  const double share = static_cast<double>(std::count_if(first, left.end(), isUncut)) / static_cast<double>(left.size());
  if (!isWholeScanMeant(job, result) || !(share > ignored_share))
    return "";
  return Diagnostic(100.0 * share, " % of the surface is not cut, such as at ", Place(places[first - left.begin()].x),
                    ": it faces away from the tool axis, or the part hides it: choose another --axis, or for a column --drive helix");
}

} // namespace

void
requireScallop(const Job& job, const Surface::ConstPtr& surface, Result& result)
{
  if (!(surface || result.mesh) || !(job.scallop > 0.0 || isWholeScanMeant(job, result)))
    return;
  const std::vector<CutPlace> places = meantPlaces(job, surface, result);
  const std::vector<double> left = leftOver(places, job, result);
  const Diagnostic uncut = uncutText(job, places, left, result);
  if (!uncut.empty())
    result.warnings.push_back(uncut);
  if (!(job.scallop > 0.0))
    return;
  const double allowed = more_left * job.scallop + job.tolerance, nothing = 2.0 * job.cutter.radius;
  std::size_t over = 0, met = 0, worst = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] >= nothing)
      continue;
    over += left[i] > allowed ? 1 : 0;
    if (met++ == 0 || left[i] > left[worst])
      worst = i;
  }
  if (over == 0)
    return;
  const double share = static_cast<double>(over) / static_cast<double>(met);
  const Diagnostic said = Diagnostic("the passes leave more than the --scallop of ", job.scallop, " mm on ", 100.0 * share,
                                     " % of the surface, up to ", left[worst], " mm at ", Place(places[worst].x));
  if (share > ignored_share)
    throw FileError(job.part, Diagnostic(said, ": ", remedyOf(job, result, left[worst]), (uncut.empty() ? "" : "; " + uncut)));
  result.warnings.push_back(Diagnostic(said, ": check this place"));
}
