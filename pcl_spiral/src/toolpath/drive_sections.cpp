// Sections of the surface with planes along the tool axis.
#include "drive_kinds.h"
#include "drive_lines.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/toolpath/path_size.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Directions of the passes and of the steps between planes, and from where their distances count. */
struct SectionFrame {
  Vector3d along, across, origin;
};

SectionFrame
frameOf(const DriveSettings& settings, const Vector3d& origin)
{
  const Vector3d axis = settings.axis.normalized();
  Vector3d along = settings.plane_direction.isZero(0.0)
                       ? Eigen::AngleAxisd(settings.plane_angle * M_PI / 180.0, axis) * referenceAcross(axis)
                       : settings.plane_direction.normalized();
  along = (along - axis * axis.dot(along)).normalized();
  return {along, axis.cross(along), origin};
}

/** Lines of one plane, each along the passes. */
void
turnAlong(std::vector<DriveLine>& lines, const Vector3d& along)
{
  for (DriveLine& line : lines)
    if (!line.closed && line.points.back().dot(along) < line.points.front().dot(along))
      std::reverse(line.points.begin(), line.points.end());
}

/** In the order in which they begin; a closed one begins where it does along the passes. */
void
sortAlong(std::vector<DriveLine>& lines, const Vector3d& along)
{
  const auto isBefore = [&](const Vector3d& a, const Vector3d& b) { return a.dot(along) < b.dot(along); };
  for (DriveLine& line : lines)
    if (line.closed)
      std::rotate(line.points.begin(), std::min_element(line.points.begin(), line.points.end(), isBefore),
                  line.points.end());
  std::stable_sort(lines.begin(), lines.end(), [&](const DriveLine& a, const DriveLine& b) {
    return isBefore(a.points.front(), b.points.front());
  });
}

void
turnBack(std::vector<DriveLine>& lines)
{
  std::reverse(lines.begin(), lines.end());
  for (DriveLine& line : lines)
    std::reverse(line.points.begin(), line.points.end());
}

} // namespace

Status
planSections(const SurfaceGraph& graph, const DriveSettings& settings, DrivePasses& passes,
             DriveReport& report)
{
  const SectionFrame frame = frameOf(settings, graph.position(0));
  std::vector<double> distance(graph.size());
  double low = 1e300, high = -1e300;
  const Triangulation mesh = withoutFlaws(graph);
  for (std::size_t i = 0; i < graph.size(); ++i)
    distance[i] = frame.across.dot(graph.position(i) - frame.origin);
  for (std::size_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    low = std::min(low, distance[mesh.origin(static_cast<std::uint32_t>(h))]);
    high = std::max(high, distance[mesh.origin(static_cast<std::uint32_t>(h))]);
  }
  if (!(high > low))
    return {StatusCode::InvalidInput,
            "the scan has no extent across the passes; turn the direction of the planes"};
  const double area = surfaceArea(graph), rows = area / settings.step_over;
  if (const Status status = checkDriveSize(rows / settings.point_spacing + (high - low) / settings.step_over,
                                           2.0 * rows / graph.spacing(), settings);
      !status.ok())
    return status;
  const EqualSteps planes = equalSteps(low, high, settings.step_over);
  report.step_over = planes.step;
  const auto lines = levelLines(mesh, distance, planes.middles);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<DriveLine> pieces = driveLines(lines[k], graph);
    turnAlong(pieces, frame.along);
    pieces = joined(std::move(pieces), widest_gap * graph.spacing());
    report.short_pieces += dropShort(pieces, graph.spacing());
    sortAlong(pieces, frame.along);
    if (settings.zigzag && k % 2 == 1)
      turnBack(pieces);
    for (const DriveLine& piece : pieces)
      passes.push_back(passAlong(piece.points, piece.closed, settings.point_spacing));
  }
  return Status::success();
}

} // namespace pcl_spiral
