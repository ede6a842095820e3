#include "bent_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double
lengthOf(const SurfaceMesh& mesh, std::uint32_t h)
{
  return (mesh.position(mesh.triangles().target(h)) - mesh.position(mesh.triangles().origin(h))).norm();
}

/** Curvature about a vertex, 1/mm: angles of the edges that leave it times their lengths, over the area of its faces; bent edges
 *  left out. These edges are two thirds of what the faces have. */
double
curvatureAbout(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& bent, std::uint32_t v)
{
  const Triangulation& t = mesh.triangles();
  double bend = 0.0, area = 0.0;
  for (std::uint32_t k = t.outgoingBegin(v); k < t.outgoingBegin(v + 1); ++k) {
    const std::uint32_t h = t.outgoing(k), other = t.opposite(h);
    area += mesh.faceArea(h / 3);
    if (other != Triangulation::none && !bent[h])
      bend += angleBetween(mesh.faceNormal(h / 3), mesh.faceNormal(other / 3)) * lengthOf(mesh, h);
  }
  return 1.5 * bend / area;
}

/** The face beyond a narrow one, across the longer of its other two edges; none at the boundary. */
std::uint32_t
faceBeyond(const SurfaceMesh& mesh, std::uint32_t h)
{
  const std::uint32_t a = Triangulation::next(h), b = Triangulation::previous(h);
  const std::uint32_t other = mesh.triangles().opposite(lengthOf(mesh, a) > lengthOf(mesh, b) ? a : b);
  return other == Triangulation::none ? other : other / 3;
}

} // namespace

std::vector<std::uint8_t>
bentEdges(const SurfaceMesh& mesh)
{
  const double least = std::cos(mesh.settings().crease_angle * M_PI / 180.0);
  std::vector<std::uint8_t> bent(mesh.triangles().halfEdgeCount(), 0);
#pragma omp parallel for schedule(static)
  for (std::int64_t h = 0; h < static_cast<std::int64_t>(bent.size()); ++h)
    if (const std::uint32_t other = mesh.triangles().opposite(static_cast<std::uint32_t>(h)); other != Triangulation::none)
      bent[h] = mesh.faceNormal(h / 3).dot(mesh.faceNormal(other / 3)) < least;
  return bent;
}

bool
standsOut(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& bent, double noise, std::uint32_t h)
{
  const Triangulation& t = mesh.triangles();
  const std::uint32_t other = t.opposite(h);
  const bool own_is_narrow = mesh.faceArea(h / 3) < mesh.faceArea(other / 3);
  const std::uint32_t narrow = own_is_narrow ? h : other, wide = own_is_narrow ? other : h;
  const std::uint32_t beyond = faceBeyond(mesh, narrow);
  const double least = std::cos(mesh.settings().crease_angle * M_PI / 180.0);
  if (beyond != Triangulation::none && mesh.faceNormal(beyond).dot(mesh.faceNormal(wide / 3)) < least)
    return true; // the part bends beyond the narrow face too, as along a chamfer
  const double edge = std::max({lengthOf(mesh, narrow), lengthOf(mesh, Triangulation::next(narrow)), lengthOf(mesh, Triangulation::previous(narrow))});
  const double sine = std::min(1.0, (mesh.faceNormal(narrow / 3) - mesh.faceNormal(wide / 3)).norm());
  const double height = 2.0 * mesh.faceArea(narrow / 3) / edge * sine;
  const double curvature = std::max(curvatureAbout(mesh, bent, t.origin(h)), curvatureAbout(mesh, bent, t.target(h)));
  const double sag = curvature * edge * edge / 8.0;
  return height > 4.0 * (noise + sag);
}

} // namespace pcl_spiral
