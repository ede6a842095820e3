// SPDX-License-Identifier: BSD-3-Clause
#include "bent_edges.h"

#include <pcl_spiral/core/impl/angles.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

double
lengthOf(const SurfaceMesh& mesh, std::uint32_t h)
{
  return (mesh.position(mesh.triangles().target(h)) - mesh.position(mesh.triangles().origin(h))).norm();
}

/** Curvature at a vertex, 1/mm: angles of the edges that leave it times their lengths, over the area of its faces; bent edges are
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

/** Whether the face beyond \p narrow, across the longer of its other two edges, or across either if they are equally long, is bent
 *  against \p wide by more than the crease angle. */
bool
bendsOnBeyond(const SurfaceMesh& mesh, std::uint32_t narrow, std::uint32_t wide)
{
  constexpr double as_long = 0.999;
  const double least = std::cos(mesh.settings().crease_angle * pi / 180.0);
  const std::uint32_t sides[2] = {Triangulation::next(narrow), Triangulation::previous(narrow)};
  const double longest = std::max(lengthOf(mesh, sides[0]), lengthOf(mesh, sides[1]));
  for (const std::uint32_t side : sides) {
    const std::uint32_t other = mesh.triangles().opposite(side);
    if (lengthOf(mesh, side) >= as_long * longest && other != Triangulation::none &&
        mesh.faceNormal(other / 3).dot(mesh.faceNormal(wide / 3)) < least)
      return true;
  }
  return false;
}

/** Whether the part is bent at an edge; \p narrow is the narrow one of its faces. */
bool
standsOutAs(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& bent, double noise, std::uint32_t narrow, std::uint32_t wide)
{
  if (bendsOnBeyond(mesh, narrow, wide))
    return true; // as along a chamfer
  const Triangulation& t = mesh.triangles();
  const double edge =
      std::max({lengthOf(mesh, narrow), lengthOf(mesh, Triangulation::next(narrow)), lengthOf(mesh, Triangulation::previous(narrow))});
  const double sine = std::min(1.0, (mesh.faceNormal(narrow / 3) - mesh.faceNormal(wide / 3)).norm());
  const double height = 2.0 * mesh.faceArea(narrow / 3) / edge * sine;
  const double curvature = std::max(curvatureAbout(mesh, bent, t.origin(narrow)), curvatureAbout(mesh, bent, t.target(narrow)));
  const double sag = curvature * edge * edge / 8.0;
  return height > 4.0 * (noise + sag);
}

} // namespace

std::vector<std::uint8_t>
bentEdges(const SurfaceMesh& mesh)
{
  const double least = std::cos(mesh.settings().crease_angle * pi / 180.0);
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
  constexpr double as_large = 0.999;
  const std::uint32_t other = mesh.triangles().opposite(h);
  const double own = mesh.faceArea(h / 3), theirs = mesh.faceArea(other / 3);
  if (own < as_large * theirs)
    return standsOutAs(mesh, bent, noise, h, other);
  if (theirs < as_large * own)
    return standsOutAs(mesh, bent, noise, other, h);
  return standsOutAs(mesh, bent, noise, h, other) && standsOutAs(mesh, bent, noise, other, h);
}

} // namespace pcl_spiral
