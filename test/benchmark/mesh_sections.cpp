// SPDX-License-Identifier: BSD-3-Clause
// Sections of a mesh with many planes, one thread: pcl_spiral with each search, compared with a loop over all triangles with points
// ordered by nearest, CGAL's Polygon_mesh_slicer and VTK's vtkCutter. pcl_spiral_benchmark_sections [landform|bonnet] [step-over]
#include "support/mesh_surfaces.h"
#include "support/meshes.h"

#include <pcl_spiral/mesh/mesh_sections.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

using Rows = std::vector<std::vector<Polyline>>; // of each plane

double
secondsOf(const std::function<void()>& work)
{
  constexpr int repetitions = 3;
  double least = INFINITY;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/** The places where each plane crosses the edges of each triangle, found by a loop over all triangles, ordered by nearest. */
Rows
plainLoop(const SurfaceMesh& mesh, const std::vector<double>& levels)
{
  Rows rows;
  for (const double level : levels) {
    Polyline places;
    for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
      const auto& f = mesh.triangles().triangle(t);
      for (int k = 0; k < 3; ++k) {
        const Vector3d &a = mesh.position(f[k]), &b = mesh.position(f[(k + 1) % 3]);
        if ((a.y() < level) != (b.y() < level))
          places.push_back(a + (level - a.y()) / (b.y() - a.y()) * (b - a));
      }
    }
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const auto nearest =
          std::min_element(places.begin() + static_cast<std::ptrdiff_t>(i) + 1, places.end(), [&](const Vector3d& a, const Vector3d& b) {
            return (a - places[i]).squaredNorm() < (b - places[i]).squaredNorm();
          });
      std::swap(places[i + 1], *nearest);
    }
    rows.push_back({places});
  }
  return rows;
}

using Kernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

CgalMesh
cgalMesh(const SurfaceMesh& mesh)
{
  CgalMesh result;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    vertices.push_back(result.add_vertex({mesh.position(v).x(), mesh.position(v).y(), mesh.position(v).z()}));
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    const auto& f = mesh.triangles().triangle(t);
    result.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
  }
  return result;
}

Rows
slicedByCgal(const CgalMesh& mesh, const std::vector<double>& levels)
{
  CGAL::Polygon_mesh_slicer<CgalMesh, Kernel> slicer(mesh);
  Rows rows;
  for (const double level : levels) {
    std::vector<std::vector<Kernel::Point_3>> lines;
    slicer(Kernel::Plane_3(0.0, 1.0, 0.0, -level), std::back_inserter(lines));
    rows.emplace_back();
    for (const auto& line : lines) {
      rows.back().emplace_back();
      for (const auto& p : line)
        rows.back().back().push_back({p.x(), p.y(), p.z()});
    }
  }
  return rows;
}

void
cutByVtk(const SurfaceMesh& mesh, const std::vector<double>& levels)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    points->InsertNextPoint(mesh.position(v).data());
  vtkNew<vtkCellArray> cells;
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    const auto& f = mesh.triangles().triangle(t);
    const vtkIdType corners[3] = {f[0], f[1], f[2]};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 1.0, 0.0);
  plane->SetOrigin(0.0, 0.0, 0.0);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(data);
  cutter->SetCutFunction(plane);
  cutter->SetNumberOfContours(static_cast<int>(levels.size()));
  for (std::size_t k = 0; k < levels.size(); ++k)
    cutter->SetValue(static_cast<int>(k), levels[k]);
  cutter->Update();
}

double
lengthOf(const Rows& rows)
{
  double sum = 0.0;
  for (const auto& row : rows)
    for (const Polyline& line : row)
      sum += length(line);
  return sum;
}

/** Largest distance of a point of \p theirs from the nearest of \p ours, in one of every hundred planes. */
double
farthest(const DrivePasses& ours, const Rows& theirs)
{
  double most = 0.0;
  for (std::size_t k = 0; k < theirs.size(); k += 100)
    for (const Polyline& line : theirs[k])
      for (const Vector3d& p : line) {
        double least = INFINITY;
        for (const DrivePass& pass : ours)
          if (std::abs(pass.points.front().position.y() - p.y()) < 1e-6)
            for (const DrivePoint& q : pass.points)
              least = std::min(least, (q.position - p).norm());
        most = std::max(most, least);
      }
  return most;
}

} // namespace

int
main(int argc, char** argv)
{
  const bool hood = argc < 2 || std::strcmp(argv[1], "bonnet") == 0;
  const double step = argc > 2 ? std::atof(argv[2]) : 2.0 * std::sqrt((2.0 * 5.0 - 0.01) * 0.01); // equation (4): R 5, H 0.01
  const test::TriangleMesh made =
      hood ? test::delaunayMesh(*test::bonnet(), {1400, 1000}, 54800, 442) : test::gridMesh(*test::landform(), {100, 100}, 49);
  const pcl::PolygonMesh::Ptr polygons = made.polygons();
  MeshSettings settings;
  settings.edges = MeshEdges::Straight;
  SurfaceMesh::ConstPtr mesh;
  if (!SurfaceMesh::make(*polygons, settings, mesh).ok())
    return 1;
  MeshSections sections;
  sections.setInputMesh(mesh);
  sections.setStepOver(step);
  sections.setChordError(1e6);
  sections.setNumberOfThreads(1);
  DrivePasses passes;
  std::printf("| %zu faces, step-over %.4f mm | s | of the plain loop |\n|---|---|---|\n", mesh->faceCount(), step);
  const double extent = hood ? 1000.0 : 100.0, count = std::ceil(extent / step - 1e-9);
  std::vector<double> levels;
  for (double k = 0.5; k < count; k += 1.0)
    levels.push_back(k * extent / count);
  Rows rows;
  const double plain = secondsOf([&] { rows = plainLoop(*mesh, levels); });
  std::printf("| loop over all triangles, nearest-point order | %.3f | 1 |\n", plain);
  const auto print = [&](const char* name, double seconds) { std::printf("| %s | %.3f | %.3f |\n", name, seconds, seconds / plain); };
  for (const auto& [search, name] :
       {std::pair(MeshSearch::LevelLines, "ours, all planes at once"), std::pair(MeshSearch::RTree, "ours, R*-tree"),
        std::pair(MeshSearch::AllFaces, "ours, loop over all triangles")}) {
    sections.setSearch(search);
    print(name, secondsOf([&] { sections.compute(passes); }));
  }
  const CgalMesh other = cgalMesh(*mesh);
  const double cgal = secondsOf([&] { rows = slicedByCgal(other, levels); });
  print("CGAL, Polygon_mesh_slicer", cgal);
  print("VTK, vtkCutter (lines not joined)", secondsOf([&] { cutByVtk(*mesh, levels); }));
  std::printf("\n%zu planes, %zu crossings, %.1f M triangles tested by the loop; length %.6f mm, CGAL's %.6f; farthest point of CGAL's "
              "lines from ours %.1e mm\n",
              levels.size(), sections.getReport().crossings, static_cast<double>(levels.size() * mesh->faceCount()) * 1e-6,
              sections.getReport().length, lengthOf(rows), farthest(passes, rows));
  MeshSections curved;
  curved.setInputMesh(polygons);
  curved.setStepOver(step);
  for (const unsigned int threads : {1u, 2u}) {
    curved.setNumberOfThreads(threads);
    std::printf("curved, from polygons to contacts, %u threads: %.3f s, ", threads, secondsOf([&] { curved.compute(passes); }));
    std::printf("%zu contacts\n", curved.getReport().points);
  }
  return 0;
}
