// SPDX-License-Identifier: BSD-3-Clause
#include "scan_links.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

double
distanceToSegment(const Vector3d& x, const Vector3d& a, const Vector3d& b)
{
  const Vector3d d = b - a;
  const double whole = d.squaredNorm();
  return (x - a - (whole > 0.0 ? std::clamp((x - a).dot(d) / whole, 0.0, 1.0) : 0.0) * d).norm();
}

double
distanceToTriangle(const Vector3d& x, const std::array<Vector3d, 3>& corners)
{
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool inside = normal.squaredNorm() > 0.0;
  double to_edges = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &a = corners[i], &b = corners[(i + 1) % 3];
    inside = inside && normal.dot((b - a).cross(x - a)) >= 0.0;
    to_edges = std::min(to_edges, distanceToSegment(x, a, b));
  }
  return inside ? std::abs(normal.normalized().dot(x - corners[0])) : to_edges;
}

/** Whether a triangle about \p vertex comes within \p most of \p x. */
bool
reaches(const SurfaceGraph& graph, const Triangulation& mesh, std::uint32_t vertex, const Vector3d& x, double most)
{
  for (std::uint32_t i = mesh.outgoingBegin(vertex); i < mesh.outgoingBegin(vertex + 1); ++i) {
    const auto& [a, b, c] = mesh.triangle(mesh.outgoing(i) / 3);
    if (distanceToTriangle(x, {graph.position(a), graph.position(b), graph.position(c)}) <= most)
      return true;
  }
  return false;
}

/** Whether a triangle about the point next to \p x, or about a neighbour of it, comes within a spacing. */
bool
isOver(const SurfaceGraph& graph, const Triangulation& mesh, std::uint32_t nearest, const Vector3d& x)
{
  const double most = graph.spacing(nearest);
  if (reaches(graph, mesh, nearest, x, most))
    return true;
  for (std::uint32_t i = mesh.outgoingBegin(nearest); i < mesh.outgoingBegin(nearest + 1); ++i)
    if (reaches(graph, mesh, mesh.target(mesh.outgoing(i)), x, most))
      return true;
  return false;
}

} // namespace

PlacesOnSurface
onScan(const Surface& surface, const Triangulation& mesh)
{
  return [&surface, &mesh](const Polyline& places) {
    std::vector<SurfaceFoot> feet;
    surface.fit().project(places, feet);
    std::vector<std::optional<DrivePoint>> points(places.size());
    for (std::size_t i = 0; i < feet.size(); ++i) {
      const SurfaceFoot& foot = feet[i];
      if (!foot.valid || surface.voids().contains(foot.position, foot.nearest) ||
          !isOver(surface.graph(), mesh, foot.nearest, foot.position))
        continue;
      points[i].emplace();
      points[i]->position = foot.position;
    }
    return points;
  };
}

} // namespace pcl_spiral
