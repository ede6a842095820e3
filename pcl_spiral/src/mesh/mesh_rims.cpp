// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/impl/mesh_rims.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

double
edgeLength(const SurfaceMesh& mesh, std::uint32_t h)
{
  constexpr int parts = 8;
  double sum = 0.0;
  Eigen::Vector3d before = edgePlace(mesh, h, 0.0);
  for (int k = 1; k <= parts; ++k) {
    const Eigen::Vector3d here = edgePlace(mesh, h, static_cast<double>(k) / parts);
    sum += (here - before).norm();
    before = here;
  }
  return sum;
}

} // namespace

Eigen::Vector3d
edgePlace(const SurfaceMesh& mesh, std::uint32_t h, double u)
{
  const Eigen::Vector3d &a = mesh.position(mesh.triangles().origin(h)), &b = mesh.position(mesh.triangles().target(h));
  return a + u * (b - a) - u * (1.0 - u) * mesh.bow(h);
}

std::vector<MeshRim>
meshRims(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen)
{
  std::vector<Triangulation::Triangle> faces;
  std::vector<std::uint32_t> face_of;
  for (std::uint32_t t = 0; t < mesh.faceCount(); ++t)
    if (chosen.empty() || chosen[t]) {
      faces.push_back(mesh.triangles().triangle(t));
      face_of.push_back(t);
    }
  std::vector<MeshRim> rims;
  for (const auto& loop : Triangulation(mesh.vertexCount(), faces).boundaryLoops()) {
    MeshRim rim;
    for (const std::uint32_t h : loop) {
      rim.half_edges.push_back(3 * face_of[h / 3] + h % 3);
      rim.length += edgeLength(mesh, rim.half_edges.back());
    }
    rims.push_back(std::move(rim));
  }
  std::stable_sort(rims.begin(), rims.end(), [](const MeshRim& a, const MeshRim& b) { return a.length > b.length; });
  return rims;
}

Polyline
rimCurve(const SurfaceMesh& mesh, const MeshRim& rim, double step)
{
  Polyline curve;
  for (const std::uint32_t h : rim.half_edges) {
    const auto parts = std::max(1, static_cast<int>(std::ceil(edgeLength(mesh, h) / step)));
    for (int k = 0; k < parts; ++k)
      curve.push_back(edgePlace(mesh, h, static_cast<double>(k) / parts));
  }
  return curve;
}

} // namespace pcl_spiral
