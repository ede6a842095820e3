// SPDX-License-Identifier: BSD-3-Clause
#include "verify/stock_cells.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl_spiral {
namespace {

/** The cell of a place: its indices in a grid, and the side that its normal faces. */
std::uint64_t
cellKey(const Eigen::Vector3f& place, const Eigen::Vector3f& normal, const Eigen::Vector3f& low, float cell)
{
  Eigen::Index side = 0;
  normal.cwiseAbs().maxCoeff(&side);
  std::uint64_t key = 2 * static_cast<std::uint64_t>(side) + (normal[side] < 0.0f);
  for (int d = 0; d < 3; ++d)
    key = key << 20 | static_cast<std::uint64_t>((place[d] - low[d]) / cell);
  return key;
}

} // namespace

StockCells
stockCells(const std::vector<Eigen::Vector3f>& places, const std::vector<Eigen::Vector3f>& normals, double area, std::size_t most)
{
  constexpr double least_growth = 1.05; // of the cells from one try to the next
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : places)
    box.extend(p);
  StockCells found;
  found.of_place.resize(places.size());
  for (double cell = std::sqrt(std::max(area, 1e-12) / static_cast<double>(most));;) {
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    numbers.reserve(2 * most);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::uint64_t key = cellKey(places[i], normals[i], box.min(), static_cast<float>(cell));
      found.of_place[i] = numbers.emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
    }
    found.cells = numbers.size();
    found.apart = std::sqrt(3.0) * cell;
    if (found.cells <= most)
      return found;
    cell *= std::max(least_growth, std::sqrt(static_cast<double>(found.cells) / static_cast<double>(most)));
  }
}

std::vector<Triangulation::Triangle>
trianglesOf(const StockCells& cells, const std::vector<Triangulation::Triangle>& triangles)
{
  std::vector<Triangulation::Triangle> between;
  for (const Triangulation::Triangle& triangle : triangles) {
    const std::uint32_t a = cells.of_place[triangle[0]], b = cells.of_place[triangle[1]], c = cells.of_place[triangle[2]];
    if (a != b && b != c && c != a)
      between.push_back({a, b, c});
  }
  return between;
}

double
triangleArea(const std::vector<Eigen::Vector3f>& places, const Triangulation::Triangle& triangle)
{
  const auto& [a, b, c] = triangle;
  return 0.5 * (places[b] - places[a]).cross(places[c] - places[a]).cast<double>().norm();
}

double
trianglesArea(const std::vector<Eigen::Vector3f>& places, const std::vector<Triangulation::Triangle>& triangles)
{
  double area = 0.0;
  for (const Triangulation::Triangle& triangle : triangles)
    area += triangleArea(places, triangle);
  return area;
}

bool
isWorseStock(float a, float b)
{
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(b) && !std::isnan(a);
  return a < 0.0f || b < 0.0f ? a < b : a > b;
}

} // namespace pcl_spiral
