// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>
#include <pcl_spiral/drive/impl/drive_path_engine.h>

#include "drive_kinds.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/surface/impl/smoothing_remedy.h>

#include "core/angle_between.h"

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

Status
planCurve(const DriveSettings& settings, DrivePasses& passes)
{
  if (const Status status = checkDriveSize(length(settings.curve, settings.curve_closed) / settings.point_spacing, 0.0, settings);
      !status.ok())
    return status;
  passes.push_back(passAlong(settings.curve, settings.curve_closed, settings.point_spacing));
  return Status::success();
}

Status
planPasses(const Surface* surface, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
           DriveReport& report)
{
  switch (settings.kind) {
  case DriveKind::Planes:
    return planSections(*surface, settings, passes, report);
  case DriveKind::Helix:
  case DriveKind::Rings:
    return planRings(settings, passes, report);
  case DriveKind::Curve:
    return planCurve(settings, passes);
  case DriveKind::BoundaryOffset:
    return planOffsets(surface->graph(), settings, progress, passes, report);
  }
  return Status::success();
}

/** Warn if the noise is large against the spacing: lines on the triangulation are ragged and interrupted then. */
void
warnOfScatter(const Surface& surface, const DriveSettings& settings, DriveReport& report)
{
  constexpr double much = 0.35; // of the spacing
  if (settings.kind != DriveKind::Planes && settings.kind != DriveKind::BoundaryOffset)
    return;
  if (const double noise = surface.noise(); noise > much * surface.spacing())
    report.warnings.push_back(Diagnostic("the noise of the points is ", noise, " {mm} (standard deviation), at a spacing of ",
                                         surface.spacing(), " {mm}: passes are ragged, and interrupted where layers overlap; ",
                                         smoothingRemedy(noise, surface.spacing())));
}

} // namespace

void
measureDrive(const DrivePasses& passes, DriveReport& report)
{
  for (const DrivePass& pass : passes) {
    const std::size_t n = pass.points.size();
    report.points += n;
    for (std::size_t i = 0; i < n; ++i) {
      const DrivePoint &a = pass.points[i], &b = pass.points[(i + 1) % n];
      if (i + 1 == n && !pass.closed)
        break;
      report.length += (b.position - a.position).norm();
      report.largest_axis_step = std::max(report.largest_axis_step, angleBetween(a.axis, b.axis));
    }
  }
  report.largest_axis_step *= 180.0 / pi;
}

Status
planDrive(const Surface::ConstPtr& surface, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
          DriveReport& report)
{
  const auto told = [&](double share, const char* stage) { return !progress || progress(share, stage); };
  if (const Status status = checkSettings(settings); !status.ok())
    return status;
  const SurfaceGraph none;
  const SurfaceGraph& graph = surface ? surface->graph() : none;
  if (surface)
    report.outlier_points = surface->report().offSurface();
  if (!told(0.0, "passes"))
    return cancelled();
  const bool round = settings.goesRound() || settings.axisMode() == DriveAxisMode::Cylinder;
  if (round) {
    report.column.emplace();
    if (const Status status = findColumn(graph, settings.cylinder, *report.column); !status.ok())
      return status;
  }
  if (surface)
    warnOfScatter(*surface, settings, report);
  if (const Status status = planPasses(surface.get(), settings, partOf(progress, 0.0, 0.5), passes, report); !status.ok())
    return status;
  if (passes.empty())
    return {StatusCode::Failed, Diagnostic("no line on the scan is longer than the spacing of its points, ", graph.spacing(),
                                           " {mm}; lower the step-over, ", report.step_over, " {mm}, or scan more densely")};
  if (!told(0.5, "axes"))
    return cancelled();
  if (const Status status = setAxes(graph, settings, partOf(progress, 0.5, 1.0), passes, report); !status.ok())
    return status;
  measureDrive(passes, report);
  if (!told(1.0, "axes"))
    return cancelled();
  return Status::success();
}

} // namespace pcl_spiral
