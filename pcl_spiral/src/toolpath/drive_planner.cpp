#include <pcl_spiral/toolpath/drive_planner.h>

#include "drive_kinds.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/surface/clean_graph.h>
#include <pcl_spiral/surface/mls_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

Status
cancelled()
{
  return {StatusCode::Cancelled, "cancelled"};
}

/** Reports of a part of the work as a share of all of it. */
ProgressCallback
part(const ProgressCallback& progress, double from, double to)
{
  return [&progress, from, to](double share, const std::string& stage) {
    return !progress || progress(from + share * (to - from), stage);
  };
}

Status
planCurve(const DriveSettings& settings, DrivePasses& passes)
{
  if (const Status status = checkDriveSize(
          length(settings.curve, settings.curve_closed) / settings.point_spacing, 0.0, settings);
      !status.ok())
    return status;
  passes.push_back(passAlong(settings.curve, settings.curve_closed, settings.point_spacing));
  return Status::success();
}

Status
planPasses(const SurfaceGraph& graph, const DriveSettings& settings, const ProgressCallback& progress,
           DrivePasses& passes, DriveReport& report)
{
  switch (settings.kind) {
  case DriveKind::Planes:
    return planSections(graph, settings, passes, report);
  case DriveKind::Helix:
  case DriveKind::Rings:
    return planRings(settings, passes, report);
  case DriveKind::Curve:
    return planCurve(settings, passes);
  case DriveKind::BoundaryOffset:
    return planOffsets(graph, settings, progress, passes, report);
  }
  return Status::success();
}

/** Lines on the triangulation are ragged, and cut, where points scatter by much of their spacing. */
void
warnOfScatter(const SurfaceGraph& graph, const DriveSettings& settings, DriveReport& report)
{
  constexpr double much = 0.35; // of the spacing
  if (settings.kind != DriveKind::Planes && settings.kind != DriveKind::BoundaryOffset)
    return;
  if (const double noise = MlsSurface(graph).noise(); noise > much * graph.spacing())
    report.warnings.push_back(textOf("the points scatter by ", noise,
                                     " mm about the surface, against a spacing of ", graph.spacing(),
                                     " mm: passes are ragged, and cut where sheets overlap; thin the "
                                     "cloud to a spacing of ",
                                     4.0 * noise, " mm"));
}

void
measure(const DrivePasses& passes, DriveReport& report)
{
  for (const DrivePass& pass : passes) {
    const std::size_t n = pass.points.size();
    report.points += n;
    for (std::size_t i = 0; i < n; ++i) {
      const DrivePoint &a = pass.points[i], &b = pass.points[(i + 1) % n];
      if (i + 1 == n && !pass.closed)
        break;
      report.length += (b.position - a.position).norm();
      report.largest_axis_step =
          std::max(report.largest_axis_step, std::atan2(a.axis.cross(b.axis).norm(), a.axis.dot(b.axis)));
    }
  }
  report.largest_axis_step *= 180.0 / M_PI;
}

} // namespace

Status
planDrive(std::vector<Eigen::Vector3f> points, const DriveSettings& settings,
          const ProgressCallback& progress, DrivePasses& passes, DriveReport& report)
{
  const auto told = [&](double share, const char* stage) { return !progress || progress(share, stage); };
  if (const Status status = checkSettings(settings); !status.ok())
    return status;
  if (points.size() < SurfaceGraph::fewest_points)
    return {StatusCode::InvalidInput,
            textOf("the cloud has ", points.size(), " usable points; a surface needs at least ",
                   SurfaceGraph::fewest_points, ": scan more densely or thin less")};
  if (!told(0.0, "surface"))
    return cancelled();
  const bool round = settings.goesRound() || settings.axisMode() == DriveAxisMode::Cylinder;
  SurfaceGraph graph;
  if (settings.kind != DriveKind::Curve || settings.axisMode() != DriveAxisMode::Fixed) {
    GraphSource source;
    if (const Status status = buildCleanGraph(std::move(points), SurfaceGraphOptions(), graph, source);
        !status.ok())
      return status;
    report.stray_points = source.strays.size();
  }
  if (!told(0.6, "passes"))
    return cancelled();
  if (round) {
    report.column.emplace();
    if (const Status status = findColumn(graph, settings.cylinder, *report.column); !status.ok())
      return status;
  }
  warnOfScatter(graph, settings, report);
  if (const Status status = planPasses(graph, settings, part(progress, 0.6, 0.8), passes, report);
      !status.ok())
    return status;
  if (passes.empty())
    return {StatusCode::Failed,
            textOf("no line of the scan is longer than its spacing, ", graph.spacing(),
                   " mm; lower the step-over, ", settings.step_over, " mm, or scan more densely")};
  if (!told(0.8, "axes"))
    return cancelled();
  if (const Status status = setAxes(graph, settings, part(progress, 0.8, 1.0), passes, report); !status.ok())
    return status;
  measure(passes, report);
  if (!told(1.0, "axes"))
    return cancelled();
  return Status::success();
}

} // namespace pcl_spiral
