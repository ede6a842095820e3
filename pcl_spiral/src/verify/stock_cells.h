// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places over a surface in the cells of a grid, to show fewer of them. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The cell of each place. */
struct StockCells {
  std::vector<std::uint32_t> of_place; ///< counted in the order of their first places
  std::size_t cells = 0;               ///< their number
  double apart = 0.0;                  ///< that places of one cell may be
};

/** At most \p most cells for \p places. The two faces of a plate stay apart by their \p normals. \p area: of the surface, mm2. */
StockCells stockCells(const std::vector<Eigen::Vector3f>& places, const std::vector<Eigen::Vector3f>& normals, double area,
                      std::size_t most);

/** \p triangles between cells in place of places, without those that have two corners in one. */
std::vector<Triangulation::Triangle> trianglesOf(const StockCells& cells, const std::vector<Triangulation::Triangle>& triangles);

/** Area of \p triangle, mm2. */
double triangleArea(const std::vector<Eigen::Vector3f>& places, const Triangulation::Triangle& triangle);
/** Area of all \p triangles, mm2. */
double trianglesArea(const std::vector<Eigen::Vector3f>& places, const std::vector<Triangulation::Triangle>& triangles);

/** Whether stock \p a matters more than \p b: gouges before heights, the larger before the smaller; NaN: not measured. */
bool isWorseStock(float a, float b);

} // namespace pcl_spiral
