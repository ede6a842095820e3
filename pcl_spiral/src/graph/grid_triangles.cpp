// SPDX-License-Identifier: BSD-3-Clause
#include "grid_triangles.h"

#include "search/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double rounding = 1.001; // of heights in single precision

/** Nodes and cells by column and row. A cell has the number of its node of least column and row. */
class GridCells {
public:
  GridCells(const std::vector<Eigen::Vector3f>& points, const HeightGrid& grid) : points_(points), heights_(points.size())
  {
    std::vector<std::array<std::int64_t, 2>> at(points.size());
    forPoints(points.size(), [&](std::uint32_t i) {
      const Eigen::Vector3d place = grid.inside(points[i].cast<double>());
      at[i] = {std::llround(place.x() / grid.cell), std::llround(place.y() / grid.cell)};
      heights_[i] = place.z();
    });
    std::array<std::int64_t, 2> low = at.front(), high = low;
    for (const auto& a : at)
      for (int k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], a[k]);
        high[k] = std::max(high[k], a[k]);
      }
    columns_ = static_cast<std::size_t>(high[0] - low[0] + 3); // one more on each side, so that every node has neighbours
    node_.assign(columns_ * static_cast<std::size_t>(high[1] - low[1] + 3), Triangulation::none);
    for (std::uint32_t i = 0; i < at.size(); ++i)
      node_[static_cast<std::size_t>(at[i][1] - low[1] + 1) * columns_ + static_cast<std::size_t>(at[i][0] - low[0] + 1)] = i;
    steepest_ = steepest_tangent * grid.cell * rounding;
    findCells();
    partCorners();
  }

  std::vector<Triangulation::Triangle> triangles() const
  {
    std::vector<Triangulation::Triangle> all;
    for (std::size_t c = 0; c + columns_ + 1 < node_.size(); ++c) {
      const std::array<std::uint32_t, 4> n = corners(c); // counter-clockwise from the least column and row
      if (cell_[c] != 0) {
        const bool first = (points_[n[0]] - points_[n[2]]).squaredNorm() <= (points_[n[1]] - points_[n[3]]).squaredNorm();
        all.push_back(first ? Triangulation::Triangle{n[0], n[1], n[2]} : Triangulation::Triangle{n[0], n[1], n[3]});
        all.push_back(first ? Triangulation::Triangle{n[0], n[2], n[3]} : Triangulation::Triangle{n[1], n[2], n[3]});
        continue;
      }
      // The cells across the two sides at each corner, of which the corner between them is cut off.
      const std::array<std::size_t, 4> across = {c - columns_, c + 1, c + columns_, c - 1}; // of sides 0-1, 1-2, 2-3, 3-0
      for (int k = 0; k < 4; ++k) {
        const int before = (k + 3) % 4, after = (k + 1) % 4;
        if (c >= columns_ && isCell(across[k]) && isCell(across[before]) && !isCell(across[after]) && !isCell(across[(k + 2) % 4]) &&
            isGentle(n[before], n[after])) {
          all.push_back({n[before], n[k], n[after]});
          break;
        }
      }
    }
    return all;
  }

private:
  bool isCell(std::size_t c) const { return c < cell_.size() && cell_[c] != 0; }

  std::array<std::uint32_t, 4> corners(std::size_t c) const
  {
    return {node_[c], node_[c + 1], node_[c + columns_ + 1], node_[c + columns_]};
  }

  bool isGentle(std::uint32_t a, std::uint32_t b) const
  {
    return a != Triangulation::none && b != Triangulation::none && std::abs(heights_[a] - heights_[b]) <= steepest_;
  }

  void findCells()
  {
    cell_.assign(node_.size(), 0);
    forPoints(node_.size() - columns_ - 1, [&](std::uint32_t c) {
      const std::array<std::uint32_t, 4> n = corners(c);
      cell_[c] = isGentle(n[0], n[1]) && isGentle(n[1], n[2]) && isGentle(n[2], n[3]) && isGentle(n[3], n[0]);
    });
  }

  /** Takes a cell away where two meet in a node alone, until none do. */
  void partCorners()
  {
    std::vector<std::size_t> changed;
    const auto part = [&](std::size_t node) {
      const std::size_t c = node, left = c - 1, below = c - columns_, both = below - 1;
      if (node < columns_ + 1 || node >= cell_.size())
        return;
      for (const auto& [a, b, x, y] : {std::array<std::size_t, 4>{c, both, left, below}, {left, below, c, both}})
        if (isCell(a) && isCell(b) && !isCell(x) && !isCell(y)) {
          const std::size_t gone = std::max(a, b);
          cell_[gone] = 0;
          changed.push_back(gone);
        }
    };
    for (std::size_t node = 0; node < cell_.size(); ++node)
      part(node);
    while (!changed.empty()) {
      const std::size_t c = changed.back();
      changed.pop_back();
      for (const std::size_t node : {c, c + 1, c + columns_, c + columns_ + 1})
        part(node);
    }
  }

  const std::vector<Eigen::Vector3f>& points_;
  std::vector<double> heights_;
  double steepest_ = 0.0; ///< difference of two heights beside each other, mm
  std::size_t columns_ = 0;
  std::vector<std::uint32_t> node_; ///< point at each node, or none
  std::vector<std::uint8_t> cell_;
};

} // namespace

Triangulation
gridTriangles(const std::vector<Eigen::Vector3f>& points, const HeightGrid& grid)
{
  return Triangulation(points.size(), GridCells(points, grid).triangles());
}

} // namespace pcl_spiral
