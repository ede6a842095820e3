// SPDX-License-Identifier: BSD-3-Clause
// Sections of the surface with planes along the tool axis.
#include "drive_kinds.h"
#include "drive_lines.h"
#include "kept_rows.h"
#include "rim_reach.h"
#include "scan_links.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

SectionFrame
frameOf(const DriveSettings& settings, const Vector3d& origin)
{
  const Vector3d axis = settings.axis.normalized();
  Vector3d along = settings.plane_direction.isZero(0.0) ? Eigen::AngleAxisd(settings.plane_angle * pi / 180.0, axis) * referenceAcross(axis)
                                                        : settings.plane_direction.normalized();
  along = (along - axis * axis.dot(along)).normalized();
  return {along, axis.cross(along), origin};
}

/** Let each line of one plane run along the passes. */
void
turnAlong(std::vector<DriveLine>& lines, const Vector3d& along)
{
  for (DriveLine& line : lines)
    if (!line.closed && line.points.back().dot(along) < line.points.front().dot(along))
      std::reverse(line.points.begin(), line.points.end());
}

/** Sort lines by where they begin along the passes; a closed line begins at its first place along them. */
void
sortAlong(std::vector<DriveLine>& lines, const Vector3d& along)
{
  const auto isBefore = [&](const Vector3d& a, const Vector3d& b) { return a.dot(along) < b.dot(along); };
  for (DriveLine& line : lines)
    if (line.closed)
      std::rotate(line.points.begin(), std::min_element(line.points.begin(), line.points.end(), isBefore), line.points.end());
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const DriveLine& a, const DriveLine& b) { return isBefore(a.points.front(), b.points.front()); });
}

void
turnBack(std::vector<DriveLine>& lines)
{
  std::reverse(lines.begin(), lines.end());
  for (DriveLine& line : lines)
    std::reverse(line.points.begin(), line.points.end());
}

/** Distance of the scan's points across the passes, and the extent of the points of \p mesh. */
struct AcrossPasses {
  std::vector<double> distance;
  double low = 1e300, high = -1e300;
};

AcrossPasses
acrossPasses(const SurfaceGraph& graph, const Triangulation& mesh, const SectionFrame& frame)
{
  AcrossPasses across;
  across.distance.resize(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i)
    across.distance[i] = frame.across.dot(graph.position(i) - frame.origin);
  for (std::size_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    const double distance = across.distance[mesh.origin(static_cast<std::uint32_t>(h))];
    across.low = std::min(across.low, distance);
    across.high = std::max(across.high, distance);
  }
  return across;
}

/** Refuse if rows this far apart have too many points. */
Status
checkSize(const SurfaceGraph& graph, const DriveSettings& settings, double extent, double step)
{
  const double rows = surfaceArea(graph) / step;
  return checkDriveSize(rows / settings.point_spacing + extent / step, 2.0 * rows / graph.spacing(), settings);
}

Status
planesOf(const Surface& surface, const DriveSettings& settings, const SectionFrame& frame, const AcrossPasses& across,
         std::vector<double>& planes, DriveReport& report)
{
  const double extent = across.high - across.low;
  if (const Status status = checkSize(surface.graph(), settings, extent, settings.step_over); !status.ok())
    return status;
  if (settings.rows == DriveRows::Even) {
    EqualSteps steps = equalSteps(across.low, across.high, settings.step_over);
    report.step_over = report.smallest_step = steps.step;
    planes = std::move(steps.middles);
  }
  else {
    RowLevels rows = keptRows(surface, settings, frame.across, frame.origin, across.low, across.high, report);
    report.step_over = rows.levels.size() > 1 ? rows.largest_step : extent;
    report.smallest_step = rows.levels.size() > 1 ? rows.smallest_step : extent;
    planes = std::move(rows.levels);
  }
  report.rows = planes.size();
  return checkSize(surface.graph(), settings, extent, extent / static_cast<double>(planes.size()));
}

/** The settings; if rows are kept, with the step-over on a plane. */
DriveSettings
withStep(DriveSettings settings)
{
  if (settings.rows == DriveRows::Kept)
    settings.step_over = *stepForScallop(CutterProfile(*settings.cutter), settings.scallop_height);
  return settings;
}

void
link(const Surface& surface, const Triangulation& mesh, const std::optional<RimReach>& reach, const DriveSettings& settings,
     DrivePasses& passes, DriveReport& report)
{
  const PlacesOnSurface on_scan = onScan(surface, mesh);
  const auto onScanOrBeyond = [&](const Polyline& places) {
    std::vector<std::optional<DrivePoint>> points = on_scan(places);
    for (std::size_t i = 0; i < places.size() && reach; ++i)
      if (!points[i] && reach->contains(places[i]))
        points[i].emplace().position = places[i];
    return points;
  };
  const LinkLimits limits{2.0 * report.step_over, std::min(settings.point_spacing, 0.5 * surface.spacing()), settings.point_spacing};
  const RowLinks links = linkRows(passes, limits, onScanOrBeyond);
  report.links = links.made;
  report.rows_apart = links.not_made;
}

} // namespace

Vector3d
acrossPlanes(const DriveSettings& settings)
{
  return frameOf(settings, Vector3d::Zero()).across;
}

Status
planSections(const Surface& surface, const DriveSettings& asked, DrivePasses& passes, DriveReport& report)
{
  const DriveSettings settings = withStep(asked);
  const SurfaceGraph& graph = surface.graph();
  const SectionFrame frame = frameOf(settings, graph.position(0));
  const Triangulation mesh = withoutFlaws(graph);
  AcrossPasses across = acrossPasses(graph, mesh, frame);
  if (!(across.high > across.low))
    return {StatusCode::InvalidInput, "the scan has no extent across the passes; turn the direction of the planes"};
  std::optional<RimReach> reach;
  if (settings.cutter && settings.axisMode() == DriveAxisMode::Fixed) {
    reach.emplace(surface, mesh, *settings.cutter, frame);
    reach->widen(across.low, across.high);
  }
  std::vector<double> planes;
  if (const Status status = planesOf(surface, settings, frame, across, planes, report); !status.ok())
    return status;
  const auto lines = levelLines(mesh, across.distance, planes);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<DriveLine> pieces = driveLines(lines[k], graph);
    turnAlong(pieces, frame.along);
    if (reach)
      for (DriveLine& line : reach->beyond(planes[k], pieces))
        pieces.push_back(std::move(line));
    pieces = joined(std::move(pieces), widest_gap * graph.spacing());
    report.short_pieces += dropShort(pieces, graph.spacing());
    sortAlong(pieces, frame.along);
    if (settings.zigzag && k % 2 == 1)
      turnBack(pieces);
    for (const DriveLine& piece : pieces)
      passes.push_back(passAlong(piece.points, piece.closed, settings.point_spacing));
  }
  if (settings.link_rows)
    link(surface, mesh, reach, settings, passes, report);
  return Status::success();
}

} // namespace pcl_spiral
