// SPDX-License-Identifier: BSD-3-Clause
#include "common/stoppable_loop.h"
#include "verify/stock_cells.h"
#include <pcl_spiral/verify/stock_mesh.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

/** The points of a surface that are shown, each for the points of its cell. */
struct ShownPoints {
  std::vector<std::uint32_t> points;
  StockCells cells; ///< of every point
};

/** Stock of point \p i of the surface; NaN: not measured. */
float
stockOf(const ReferenceSurface& reference, const std::vector<float>& stock, std::size_t i)
{
  const std::uint32_t source = reference.scanned().sourceIndex(i);
  return source < stock.size() ? stock[source] : std::numeric_limits<float>::quiet_NaN();
}

ShownPoints
allPoints(const SurfaceGraph& graph)
{
  ShownPoints shown;
  shown.points.resize(graph.size());
  std::iota(shown.points.begin(), shown.points.end(), 0U);
  shown.cells.of_place = shown.points;
  return shown;
}

/** The point with the worst stock of each cell. */
ShownPoints
worstPoints(const ReferenceSurface& reference, const std::vector<float>& stock, std::size_t most)
{
  const SurfaceGraph& graph = reference.graph();
  std::vector<Eigen::Vector3f> places, normals;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    places.push_back(graph.position(i).cast<float>());
    normals.push_back(graph.normal(i).cast<float>());
  }
  double area = 0.0;
  for (std::size_t t = 0; t < graph.triangulation().triangleCount(); ++t)
    area += triangleArea(places, graph.triangulation().triangle(t));
  ShownPoints shown;
  shown.cells = stockCells(places, normals, area, most);
  shown.points.assign(shown.cells.cells, Triangulation::none);
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    if (std::uint32_t& worst = shown.points[shown.cells.of_place[i]];
        worst == Triangulation::none || isWorseStock(stockOf(reference, stock, i), stockOf(reference, stock, worst)))
      worst = i;
  return shown;
}

/** Adds the tops over \p shown. Returns the number of each in the mesh. */
std::vector<std::uint32_t>
addTops(const ReferenceSurface& reference, const std::vector<float>& stock, const std::vector<std::uint32_t>& shown, StockMesh& mesh)
{
  std::vector<std::uint32_t> number(shown.size(), Triangulation::none);
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < shown.size(); begin += report_chunk) {
    const std::size_t end = std::min(shown.size(), begin + report_chunk);
    queries.clear();
    for (std::size_t k = begin; k < end; ++k)
      queries.push_back(reference.graph().position(shown[k]));
    reference.surface().project(queries, feet);
    for (std::size_t k = begin; k < end; ++k) {
      const SurfaceFoot foot = reference.inCreaseBand(queries[k - begin]) ? reference.meshPlace(shown[k]) : feet[k - begin];
      const float height = stockOf(reference, stock, shown[k]);
      if (!foot.valid || std::isnan(height))
        continue;
      number[k] = static_cast<std::uint32_t>(mesh.places.size());
      mesh.places.push_back((foot.position + static_cast<double>(height) * foot.normal).cast<float>());
      mesh.normals.push_back(foot.normal.cast<float>());
      mesh.stock.push_back(height);
    }
  }
  return number;
}

} // namespace

StockMesh
stockMesh(const ReferenceSurface& reference, const std::vector<float>& stock, std::size_t most)
{
  const SurfaceGraph& graph = reference.graph();
  ShownPoints shown = graph.size() > most ? worstPoints(reference, stock, most) : allPoints(graph);
  StockMesh mesh;
  const std::vector<std::uint32_t> number = addTops(reference, stock, shown.points, mesh);
  for (std::uint32_t& cell : shown.cells.of_place)
    cell = number[cell];
  const Triangulation& triangles = graph.triangulation();
  for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
    Triangulation::Triangle corners = triangles.triangle(t);
    for (std::uint32_t& corner : corners)
      corner = shown.cells.of_place[corner];
    const auto& [a, b, c] = corners;
    if (a != b && b != c && c != a && std::find(corners.begin(), corners.end(), Triangulation::none) == corners.end())
      mesh.triangles.push_back(corners);
  }
  return mesh;
}

void
append(const StockMesh& more, StockMesh& mesh)
{
  const auto first = static_cast<std::uint32_t>(mesh.places.size());
  mesh.places.insert(mesh.places.end(), more.places.begin(), more.places.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  mesh.stock.insert(mesh.stock.end(), more.stock.begin(), more.stock.end());
  for (const Triangulation::Triangle& t : more.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

} // namespace pcl_spiral
