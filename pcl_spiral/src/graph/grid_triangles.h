// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles of a height field. Private.
 */
#pragma once

#include <pcl_spiral/core/height_grid.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** The triangles of \p points, nodes of \p grid: two for each cell of four nodes of which no side is steeper than steepest_tangent, with
 *  the shorter diagonal, and one in the corner of an outline. No two cells meet in a node alone, so that the mesh is a manifold without
 *  handles, whatever the heights are. */
Triangulation gridTriangles(const std::vector<Eigen::Vector3f>& points, const HeightGrid& grid);

} // namespace pcl_spiral
