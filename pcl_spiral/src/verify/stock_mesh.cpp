// SPDX-License-Identifier: BSD-3-Clause
#include "common/stoppable_loop.h"
#include <pcl_spiral/verify/stock_mesh.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {} // namespace

StockMesh
stockMesh(const ReferenceSurface& reference, const std::vector<float>& stock)
{
  const SurfaceGraph& graph = reference.graph();
  StockMesh mesh;
  std::vector<std::uint32_t> number(graph.size(), Triangulation::none); // of the points that are kept
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < graph.size(); begin += report_chunk) {
    const std::size_t end = std::min(graph.size(), begin + report_chunk);
    queries.clear();
    for (std::size_t i = begin; i < end; ++i)
      queries.push_back(graph.position(i));
    reference.surface().project(queries, feet);
    for (std::size_t i = begin; i < end; ++i) {
      const SurfaceFoot foot = reference.inCreaseBand(queries[i - begin]) ? reference.meshPlace(i) : feet[i - begin];
      const std::uint32_t source = reference.scanned().sourceIndex(i);
      if (!foot.valid || source >= stock.size() || std::isnan(stock[source]))
        continue;
      number[i] = static_cast<std::uint32_t>(mesh.places.size());
      mesh.places.push_back((foot.position + static_cast<double>(stock[source]) * foot.normal).cast<float>());
      mesh.normals.push_back(foot.normal.cast<float>());
      mesh.stock.push_back(stock[source]);
    }
  }
  const Triangulation& triangles = graph.triangulation();
  for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
    Triangulation::Triangle corners = triangles.triangle(t);
    for (std::uint32_t& corner : corners)
      corner = number[corner];
    if (std::find(corners.begin(), corners.end(), Triangulation::none) == corners.end())
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
