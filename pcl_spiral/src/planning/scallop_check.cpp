// SPDX-License-Identifier: BSD-3-Clause
#include "planning/scallop_check.h"

#include "cutter/swept_heights.h"
#include "cutter/tool_body.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/mesh/mesh_sampling.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace pcl_spiral {

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

Status
meshPlaces(unsigned int threads, const SurfaceMesh::ConstPtr& mesh, std::vector<CutPlace>& places)
{
  MeshSampling sampling;
  sampling.setInputMesh(mesh);
  sampling.setNumberOfThreads(threads);
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  const std::size_t every = 1 + samples.size() / most_places;
  for (std::size_t i = 0; i < samples.size(); i += every)
    places.push_back({samples[i].getVector3fMap().cast<double>(), samples[i].getNormalVector3fMap().cast<double>()});
  return sampling.getStatus();
}

/** Takes away the places that locations which were left out would have cut: they are nearer to one of those than to any other. */
void
withoutLeftOut(const PassPlan& plan, std::vector<CutPlace>& places)
{
  if (plan.left_out.contacts.empty())
    return;
  std::vector<Eigen::Vector3f> left_out, cut;
  for (const Vector3d& contact : plan.left_out.contacts)
    left_out.push_back(contact.cast<float>());
  for (const ToolPoses& pass : plan.passes)
    for (const ToolPose& pose : pass)
      cut.push_back(pose.contact.cast<float>());
  const PointBlocks others(std::move(left_out)), own(std::move(cut));
  const auto distance = [](const PointBlocks& points, const Vector3d& x) { return (points.position(points.nearest(x)) - x).norm(); };
  const auto isLeftOut = [&](const CutPlace& place) { return distance(others, place.x) < distance(own, place.x); };
  places.erase(std::remove_if(places.begin(), places.end(), isLeftOut), places.end());
}

/** Places that the path is meant to cut: not those of locations left out, and of a column those between its first and last contact. */
Status
meantPlaces(const DrivePlanInput& input, const PassPlan& plan, std::vector<CutPlace>& places)
{
  if (!plan.mesh)
    places = scanPlaces(*plan.surface);
  else if (const Status status = meshPlaces(input.surface.threads, plan.mesh, places); !status.ok())
    return status;
  withoutLeftOut(plan, places);
  if (!input.drive.goesRound())
    return Status::success();
  const Vector3d& up = plan.drive.column->cylinder.direction;
  double low = 1e300, high = -1e300;
  for (const ToolPoses& pass : plan.passes)
    for (const ToolPose& pose : pass) {
      low = std::min(low, up.dot(pose.contact));
      high = std::max(high, up.dot(pose.contact));
    }
  const auto isBeyond = [&](const CutPlace& place) { return up.dot(place.x) < low || up.dot(place.x) > high; };
  places.erase(std::remove_if(places.begin(), places.end(), isBeyond), places.end());
  return Status::success();
}

/** What is left over each place: the height along its normal, or, where that is more than asked for, the distance from what is cut, which
 *  is less in a corner; twice the radius of the cutter if nothing is cut below that height. */
std::vector<double>
leftOver(const std::vector<CutPlace>& places, const DrivePlanInput& input, const PassPlan& plan)
{
  std::vector<std::vector<CutterPlace>> passes;
  for (const ToolPoses& pass : plan.passes) {
    passes.emplace_back();
    for (const ToolPose& pose : pass)
      passes.back().push_back({pose.tip, pose.axis});
  }
  const double nothing = 2.0 * input.tool.cutter.radius;
  const CutterProfile cutter(input.tool.cutter);
  const SweptHeights swept(cutter, toolLength(cutter, input.tool.holder), passes);
  std::vector<double> left(places.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(places.size()); ++i) {
    left[i] = swept.over(places[i].x, places[i].normal, nothing);
    if (left[i] > input.drive.scallop_height && left[i] < nothing &&
        input.tool.cutter.corner_radius > 0.0) // a sharp edge leaves steps as high
      left[i] = swept.distance(places[i].x, left[i]);
  }
  return left;
}

/** A larger height is no remedy: where the step-over follows from it, the passes leave more again. */
Diagnostic
remedyOf(const DrivePlanInput& input, const PassPlan& plan)
{
  const bool can_keep = input.drive.kind == DriveKind::Planes && input.drive.rows == DriveRows::Even && !input.mesh &&
                        input.drive.axisMode() != DriveAxisMode::Cylinder;
  return Diagnostic(can_keep ? "use {setRows} kept" : "take a cutter with a smaller radius", ", or give {setStepOver} ",
                    plan.drive.step_over, " instead of {setScallopHeight}, which promises no height");
}

/** Whether rows are even or kept over all of a scan, and nothing else says what they leave out. */
bool
isWholeScanMeant(const DrivePlanInput& input, const PassPlan& plan)
{
  return input.drive.kind == DriveKind::Planes && input.drive.axisMode() == DriveAxisMode::Fixed && !plan.mesh &&
         plan.chosen.keep_outs.empty() && plan.drive.step_over <= input.tool.cutter.radius;
}

/** How much of the surface a fixed axis does not reach; empty if no more than rims. */
Diagnostic
uncutText(const DrivePlanInput& input, const std::vector<CutPlace>& places, const std::vector<double>& left, const PassPlan& plan)
{
  const auto isUncut = [&](double height) { return height >= 2.0 * input.tool.cutter.radius; };
  const auto first = std::find_if(left.begin(), left.end(), isUncut);
  const double share = static_cast<double>(std::count_if(first, left.end(), isUncut)) / static_cast<double>(left.size());
  if (!isWholeScanMeant(input, plan) || !(share > ignored_share))
    return "";
  return Diagnostic(100.0 * share, " % of the surface is not cut, such as at ", Place(places[first - left.begin()].x),
                    ": it faces away from the tool axis, or the part hides it: choose another {setAxis}, or for a column {setKind} helix");
}

} // namespace

Status
checkScallop(const DrivePlanInput& input, PassPlan& plan)
{
  const double scallop = input.drive.scallop_height;
  if (!(plan.surface || plan.mesh) || !(scallop > 0.0 || isWholeScanMeant(input, plan)))
    return Status::success();
  std::vector<CutPlace> places;
  if (const Status status = meantPlaces(input, plan, places); !status.ok())
    return status;
  const std::vector<double> left = leftOver(places, input, plan);
  const Diagnostic uncut = uncutText(input, places, left, plan);
  if (!uncut.empty())
    plan.warnings.push_back(uncut);
  if (!(scallop > 0.0))
    return Status::success();
  const double allowed = more_left * scallop + input.tool.tolerance, nothing = 2.0 * input.tool.cutter.radius;
  std::size_t over = 0, met = 0, worst = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] >= nothing)
      continue;
    over += left[i] > allowed ? 1 : 0;
    if (met++ == 0 || left[i] > left[worst])
      worst = i;
  }
  if (over == 0)
    return Status::success();
  const double share = static_cast<double>(over) / static_cast<double>(met);
  const Diagnostic said("the passes leave more than the {setScallopHeight} of ", scallop, " {mm} on ", 100.0 * share,
                        " % of the surface, up to ", left[worst], " {mm} at ", Place(places[worst].x));
  if (share > ignored_share)
    return {StatusCode::Failed, Diagnostic(said, ": ", remedyOf(input, plan), uncut.empty() ? uncut : "; " + uncut)};
  plan.warnings.push_back(Diagnostic(said, ": check this place"));
  return Status::success();
}

} // namespace pcl_spiral
