// SPDX-License-Identifier: BSD-3-Clause
#include "support/meshes.h"

#include "support/sampling.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <vtkCellArray.h>
#include <vtkDelaunay2D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace pcl_spiral::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/** Point \p k of \p n at equal distances along the rim, from the origin. */
Vector2d
rimPoint(const Vector2d& extent, std::size_t k, std::size_t n)
{
  // Each side gets its share of points, and always its corners.
  const double w = extent.x(), h = extent.y(), around = 2.0 * (w + h);
  const auto across = static_cast<std::size_t>(std::lround(static_cast<double>(n) * w / around)), up = n / 2 - across;
  const double u = static_cast<double>(k % (across + up));
  const bool second = k >= across + up;
  const Vector2d p = u < static_cast<double>(across) ? Vector2d(w * u / static_cast<double>(across), 0.0)
                                                     : Vector2d(w, h * (u - static_cast<double>(across)) / static_cast<double>(up));
  return second ? Vector2d(extent - p) : p;
}

/** Turned so that the face looks up. */
std::array<std::uint32_t, 3>
upwards(const std::vector<Vector3d>& v, std::array<std::uint32_t, 3> f)
{
  const Vector2d a = (v[f[1]] - v[f[0]]).head<2>(), b = (v[f[2]] - v[f[0]]).head<2>();
  if (a.x() * b.y() - a.y() * b.x() < 0.0)
    std::swap(f[1], f[2]);
  return f;
}

} // namespace

pcl::PolygonMesh::Ptr
TriangleMesh::polygons() const
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const Vector3d& v : vertices)
    cloud.push_back(pcl::PointXYZ(static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())));
  const pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
  pcl::toPCLPointCloud2(cloud, mesh->cloud);
  for (const auto& f : faces) {
    mesh->polygons.emplace_back();
    mesh->polygons.back().vertices.assign(f.begin(), f.end());
  }
  return mesh;
}

TriangleMesh
gridMesh(const AnalyticSurface& surface, const Vector2d& extent, std::size_t cells, double jitter, std::uint64_t seed)
{
  Random random(seed);
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(cells + 1);
  const Vector2d cell = extent / static_cast<double>(cells);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      Vector2d u(i * cell.x(), j * cell.y());
      if (i > 0 && i + 1 < n)
        u.x() += jitter * cell.x() * random.uniform(-1.0, 1.0);
      if (j > 0 && j + 1 < n)
        u.y() += jitter * cell.y() * random.uniform(-1.0, 1.0);
      mesh.vertices.push_back(surface.lift(u));
    }
  for (std::uint32_t j = 0; j + 1 < n; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = b + n, d = a + n;
      if (jitter > 0.0 && random.uniform() < 0.5) {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
      else {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      }
    }
  return mesh;
}

TriangleMesh
delaunayMesh(const AnalyticSurface& surface, const Vector2d& extent, std::size_t count, std::size_t on_rim, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vector2d> places;
  for (std::size_t k = 0; k < on_rim; ++k)
    places.push_back(rimPoint(extent, k, on_rim));
  while (places.size() < count)
    places.push_back({extent.x() * random.uniform(), extent.y() * random.uniform()});
  TriangleMesh mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector2d& p : places) {
    points->InsertNextPoint(p.x(), p.y(), 0.0);
    mesh.vertices.push_back(surface.lift(p));
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(input);
  delaunay->SetTolerance(0.0);
  delaunay->SetOffset(20.0);
  delaunay->Update();
  vtkCellArray* cells = delaunay->GetOutput()->GetPolys();
  vtkIdType size;
  const vtkIdType* corner;
  for (cells->InitTraversal(); cells->GetNextCell(size, corner);)
    mesh.faces.push_back(upwards(mesh.vertices, {static_cast<std::uint32_t>(corner[0]), static_cast<std::uint32_t>(corner[1]),
                                                 static_cast<std::uint32_t>(corner[2])}));
  return mesh;
}

TriangleMesh
withNoise(TriangleMesh mesh, double sigma, std::uint64_t seed)
{
  Random random(seed);
  for (Vector3d& v : mesh.vertices)
    v.z() += sigma * random.normal();
  return mesh;
}

TriangleMesh
ruggedMesh(std::uint64_t seed)
{
  constexpr std::uint32_t cells = 24;
  Random random(seed);
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const double x = i + random.uniform(-0.4, 0.4), y = j + random.uniform(-0.4, 0.4);
      mesh.vertices.emplace_back(x, y, 5.0 * std::sin(x) + std::cos(0.7 * y) + random.uniform(-0.4, 0.4));
      if (const std::uint32_t v = j * (cells + 1) + i; i < cells && j < cells) {
        mesh.faces.push_back({v, v + 1, v + cells + 2});
        mesh.faces.push_back({v, v + cells + 2, v + cells + 1});
      }
    }
  return mesh;
}

void
writeStl(const std::string& file, const TriangleMesh& mesh)
{
  std::ofstream out(file, std::ios::binary);
  const std::string header(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.faces.size());
  out.write(header.data(), 80);
  out.write(reinterpret_cast<const char*>(&count), 4);
  for (const auto& f : mesh.faces) {
    const std::array<float, 3> normal{0.0F, 0.0F, 0.0F};
    out.write(reinterpret_cast<const char*>(normal.data()), 12);
    for (const std::uint32_t v : f) {
      const Eigen::Vector3f p = mesh.vertices[v].cast<float>();
      out.write(reinterpret_cast<const char*>(p.data()), 12);
    }
    const std::uint16_t attribute = 0;
    out.write(reinterpret_cast<const char*>(&attribute), 2);
  }
}

} // namespace pcl_spiral::test
