// SPDX-License-Identifier: BSD-3-Clause
#include "welded_faces.h"

#include <pcl_spiral/core/diagnostic.h>

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Triangle = Triangulation::Triangle;

bool
hasCoordinates(const pcl::PCLPointCloud2& cloud)
{
  int found = 0;
  for (const auto& field : cloud.fields)
    found += (field.name == "x" || field.name == "y" || field.name == "z") && field.datatype == pcl::PCLPointField::FLOAT32;
  return found == 3;
}

/** Order by place: -0 counts as 0. */
bool
isBefore(const pcl::PointXYZ& a, const pcl::PointXYZ& b)
{
  if (a.x != b.x)
    return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/** For each point, the first point at the same place. */
std::vector<std::uint32_t>
firstInPlace(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  std::vector<std::uint32_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return isBefore(points[a], points[b]) || (!isBefore(points[b], points[a]) && a < b); });
  for (std::size_t k = 0; k < order.size(); ++k)
    first[order[k]] = k > 0 && !isBefore(points[order[k - 1]], points[order[k]]) ? first[order[k - 1]] : order[k];
  return first;
}

/** Faces in the order of the file, corners named by the points of the file. */
Status
triangleList(const pcl::PolygonMesh& mesh, const pcl::PointCloud<pcl::PointXYZ>& points, std::vector<Triangle>& faces)
{
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const auto& corners = mesh.polygons[f].vertices;
    for (const auto v : corners) {
      if (static_cast<std::size_t>(v) >= points.size())
        return {StatusCode::InvalidInput, Diagnostic("face ", f, " has the corner ", v, ", but there are ", points.size(),
                                                     " points, numbered from 0: export the mesh again")};
      if (!points[v].getVector3fMap().allFinite())
        return {StatusCode::InvalidInput, Diagnostic("corner ", v, " of face ", f, " is not finite: repair the mesh, or export it again")};
    }
    if (corners.size() < 3)
      return {StatusCode::InvalidInput,
              Diagnostic("face ", f, " has ", corners.size(), " corners, but needs three: export the mesh again")};
    for (std::size_t k = 2; k < corners.size(); ++k)
      faces.push_back(
          {static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[k - 1]), static_cast<std::uint32_t>(corners[k])});
  }
  return Status::success();
}

/** Whether the corners lie in one place or on one line. */
bool
hasNoArea(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  constexpr double flattest = 1e-9; // height over the longest edge
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !((b - a).cross(c - a).norm() > flattest * longest);
}

/** The faces without those whose corners an earlier one has, in either direction. */
void
dropRepeated(WeldedFaces& welded, MeshReport& counts)
{
  const std::size_t n = welded.faces.size();
  std::vector<Triangle> sorted = welded.faces;
  for (Triangle& t : sorted)
    std::sort(t.begin(), t.end());
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return sorted[a] < sorted[b] || (sorted[a] == sorted[b] && a < b); });
  std::vector<std::uint8_t> repeats(n, 0);
  for (std::size_t k = 1; k < n; ++k)
    repeats[order[k]] = sorted[order[k]] == sorted[order[k - 1]];
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < n; ++t)
    if (repeats[t])
      counts.repeated.add(welded.positions[welded.faces[t][0]]);
    else
      kept.push_back(welded.faces[t]);
  welded.faces = std::move(kept);
}

} // namespace

Status
weldFaces(const pcl::PolygonMesh& mesh, WeldedFaces& welded, MeshReport& counts)
{
  if (!hasCoordinates(mesh.cloud) || mesh.cloud.width == 0 || mesh.cloud.height == 0)
    return {StatusCode::InvalidInput, "the mesh has no points with x, y and z in single precision: call {setInputMesh} with such a mesh"};
  if (mesh.polygons.empty())
    return {StatusCode::InvalidInput,
            Diagnostic("the mesh has ", mesh.cloud.width * mesh.cloud.height,
                       " points but no faces: give its points as a cloud ({setInputCloud}), or export it with faces")};
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::fromPCLPointCloud2(mesh.cloud, points);
  std::vector<Triangle> faces;
  if (const Status status = triangleList(mesh, points, faces); !status.ok())
    return status;
  counts.given_faces = faces.size();
  const std::vector<std::uint32_t> first = firstInPlace(points);
  constexpr std::uint32_t unused = Triangulation::none;
  std::vector<std::uint32_t> vertex_of(points.size(), unused);
  const auto place = [&](std::uint32_t v) { return points[v].getVector3fMap().cast<double>().eval(); };
  for (std::size_t v = 0; v < points.size(); ++v)
    if (first[v] != v)
      counts.welded.add(place(static_cast<std::uint32_t>(v)));
  for (const Triangle& face : faces) {
    if (hasNoArea(place(face[0]), place(face[1]), place(face[2]))) {
      counts.without_area.add(place(face[0]));
      continue;
    }
    Triangle t;
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& vertex = vertex_of[first[face[k]]];
      if (vertex == unused) {
        vertex = static_cast<std::uint32_t>(welded.positions.size());
        welded.positions.push_back(place(face[k]));
      }
      t[k] = vertex;
    }
    welded.faces.push_back(t);
  }
  if (welded.faces.empty())
    return {StatusCode::InvalidInput,
            Diagnostic("none of the ", faces.size(), " faces has an area; the first is at ", Place(counts.without_area.place),
                       ": is the mesh in another unit, or rounded too much? Export it again")};
  dropRepeated(welded, counts);
  return Status::success();
}

} // namespace pcl_spiral
