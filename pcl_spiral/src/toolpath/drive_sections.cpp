// Sections of the surface with planes along the tool axis.
#include "drive_kinds.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/search/level_lines.h>
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

struct Piece {
  Polyline points;
  bool closed;
};

/** The pieces of one plane in the order of travel: each runs along the passes, a closed one from where it
 * begins there. */
std::vector<Piece>
ordered(std::vector<Piece> pieces, const Vector3d& along)
{
  for (Piece& piece : pieces) {
    if (piece.closed)
      std::rotate(piece.points.begin(),
                  std::min_element(piece.points.begin(), piece.points.end(),
                                   [&](const auto& a, const auto& b) { return a.dot(along) < b.dot(along); }),
                  piece.points.end());
    else if (piece.points.back().dot(along) < piece.points.front().dot(along))
      std::reverse(piece.points.begin(), piece.points.end());
  }
  std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return a.points.front().dot(along) < b.points.front().dot(along);
  });
  return pieces;
}

void
turnBack(std::vector<Piece>& pieces)
{
  std::reverse(pieces.begin(), pieces.end());
  for (Piece& piece : pieces)
    std::reverse(piece.points.begin(), piece.points.end());
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
    std::vector<Piece> pieces;
    for (const LevelLine& line : lines[k]) {
      Polyline points = pointsOf(line, graph.blocks());
      if (length(points, line.closed) < graph.spacing())
        ++report.short_pieces;
      else
        pieces.push_back({std::move(points), line.closed});
    }
    pieces = ordered(std::move(pieces), frame.along);
    if (settings.zigzag && k % 2 == 1)
      turnBack(pieces);
    for (const Piece& piece : pieces)
      passes.push_back(passAlong(piece.points, piece.closed, settings.point_spacing));
  }
  return Status::success();
}

} // namespace pcl_spiral
