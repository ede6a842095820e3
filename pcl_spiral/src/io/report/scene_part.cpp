// SPDX-License-Identifier: BSD-3-Clause
#include "scene_part.h"

#include "verify/stock_cells.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl_spiral {
namespace {

/** The part with the places of each cell merged into the first. */
ScenePart
mergedPart(const ScenePart& part, const StockCells& cells)
{
  const std::vector<std::uint32_t>& cell = cells.of_place;
  ScenePart merged;
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    const bool first = cell[i] == merged.places.size();
    if (first) {
      merged.places.push_back(part.places[i]);
      merged.normals.push_back(part.normals[i]);
    }
    if (part.stock.empty())
      continue;
    if (first)
      merged.stock.push_back(part.stock[i]);
    else if (isWorseStock(part.stock[i], merged.stock[cell[i]]))
      merged.stock[cell[i]] = part.stock[i];
  }
  merged.triangles = trianglesOf(cells, part.triangles);
  return merged;
}

/** Halves each edge longer than \p longest, and so cuts its triangles. Returns whether there was one. */
bool
halveEdges(float longest, ScenePart& part)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b) {
    if ((part.places[a] - part.places[b]).norm() <= longest)
      return Triangulation::none;
    const auto [found, added] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(part.places.size()));
    if (added) {
      part.places.push_back(0.5f * (part.places[a] + part.places[b]));
      part.normals.push_back((part.normals[a] + part.normals[b]).normalized());
    }
    return found->second;
  };
  std::vector<Triangulation::Triangle> pieces;
  for (const Triangulation::Triangle& t : part.triangles) {
    std::vector<std::uint32_t> ring; // corners and middles in order
    for (int i = 0; i < 3; ++i) {
      ring.push_back(t[i]);
      if (const std::uint32_t middle = middleOf(t[i], t[(i + 1) % 3]); middle != Triangulation::none)
        ring.push_back(middle);
    }
    if (ring.size() == 6)
      pieces.insert(pieces.end(),
                    {{ring[0], ring[1], ring[5]}, {ring[1], ring[2], ring[3]}, {ring[3], ring[4], ring[5]}, {ring[1], ring[3], ring[5]}});
    else if (ring.size() == 3)
      pieces.push_back(t);
    else {
      const auto middle = std::find_if(ring.begin(), ring.end(), [&](std::uint32_t v) { return v != t[0] && v != t[1] && v != t[2]; });
      std::rotate(ring.begin(), middle, ring.end()); // a fan from a middle has no triangle without area
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        pieces.push_back({ring[0], ring[i], ring[i + 1]});
    }
  }
  part.triangles = std::move(pieces);
  return !middles.empty();
}

} // namespace

void
addSurface(const Surface& surface, const std::vector<float>& stock, ScenePart& part)
{
  const auto first = static_cast<std::uint32_t>(part.places.size());
  if (!stock.empty())
    part.stock.resize(first, std::numeric_limits<float>::quiet_NaN()); // parts before may have none
  for (std::size_t i = 0; i < surface.size(); ++i) {
    part.places.push_back(surface.position(i).cast<float>());
    part.normals.push_back(surface.normal(i).cast<float>());
    if (!stock.empty()) {
      const std::uint32_t source = surface.sourceIndex(i);
      part.stock.push_back(source < stock.size() ? stock[source] : std::numeric_limits<float>::quiet_NaN());
    }
  }
  const Triangulation& triangles = surface.graph().triangulation();
  for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
    const auto& [a, b, c] = triangles.triangle(t);
    part.triangles.push_back({first + a, first + b, first + c});
  }
}

void
addMesh(const SurfaceMesh& mesh, std::size_t most, ScenePart& part)
{
  constexpr float finest = 0.01f; // of the size of the mesh
  ScenePart own;
  std::vector<std::uint32_t> number(mesh.sectorCount(), Triangulation::none); // places at creases have a normal for each side
  Eigen::AlignedBox3f box;
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    Triangulation::Triangle corners{};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t h = 3 * static_cast<std::uint32_t>(t) + i;
      std::uint32_t& at = number[mesh.sector(h)];
      if (at == Triangulation::none) {
        at = static_cast<std::uint32_t>(own.places.size());
        own.places.push_back(mesh.position(mesh.triangles().origin(h)).cast<float>());
        own.normals.push_back(mesh.normal(h).cast<float>());
        box.extend(own.places.back());
      }
      corners[i] = at;
    }
    own.triangles.push_back(corners);
  }
  const float longest = std::max(finest * box.diagonal().norm(),
                                 2.0f * std::sqrt(static_cast<float>(trianglesArea(own.places, own.triangles)) / static_cast<float>(most)));
  while (own.places.size() < most && halveEdges(longest, own)) {
  }
  const auto first = static_cast<std::uint32_t>(part.places.size());
  part.places.insert(part.places.end(), own.places.begin(), own.places.end());
  part.normals.insert(part.normals.end(), own.normals.begin(), own.normals.end());
  for (const auto& [a, b, c] : own.triangles)
    part.triangles.push_back({first + a, first + b, first + c});
}

double
thinPart(std::size_t most, ScenePart& part)
{
  if (part.places.size() <= most)
    return 0.0;
  const StockCells cells = stockCells(part.places, part.normals, trianglesArea(part.places, part.triangles), most);
  part = mergedPart(part, cells);
  return cells.apart;
}

} // namespace pcl_spiral
