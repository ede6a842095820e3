// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface of a scan after cutting.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl_spiral {

/** Triangles over the tops of the stock. Lengths in mm. */
struct StockMesh {
  std::vector<Eigen::Vector3f> places;            ///< foot of each point on the fitted surface, raised by its stock
  std::vector<Eigen::Vector3f> normals;           ///< of that surface at the foot, unit
  std::vector<float> stock;                       ///< of each place; negative: gouge
  std::vector<Triangulation::Triangle> triangles; ///< counter-clockwise seen from outside; empty: the surface has none
};

/** The mesh of the points with a measured stock, in the order of the surface. \p stock: one value for each point that the reference was
 *  made of, as MaterialRemoval and PathVerifier::getHeights (Heights::stock) give it. Of more points than \p most, those with the worst
 *  stock of each cell of a grid are taken: the deepest gouge, else the highest stock. */
StockMesh stockMesh(const ReferenceSurface& reference, const std::vector<float>& stock,
                    std::size_t most = std::numeric_limits<std::size_t>::max());

/** Adds \p more to \p mesh, as the stock of another region. */
void append(const StockMesh& more, StockMesh& mesh);

} // namespace pcl_spiral
