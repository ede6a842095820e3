// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles of a part for a page. Private to io. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/surface/surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Places of a surface, and triangles over them. */
struct ScenePart {
  std::vector<Eigen::Vector3f> places;            ///< corners of triangles
  std::vector<Eigen::Vector3f> normals;           ///< of each place, unit, out of the material
  std::vector<Triangulation::Triangle> triangles; ///< counter-clockwise seen from outside
  std::vector<float> stock;                       ///< left at each place after the cut; negative: gouge; NaN: not measured; or empty
  std::vector<float> deviation;                   ///< of the contact nearest to each place; NaN: not measured; or empty
  std::vector<float> cut_at;                      ///< when the stock of each place falls to what is left, s; infinite: never; or empty
  std::vector<float> first_at;                    ///< when it falls first, s; empty: all falls at cut_at
  std::vector<float> first_stock;                 ///< to what it falls first
};

/** Adds the points of \p surface. \p stock: one value for each point of its cloud, as Heights::stock; or empty. */
void addSurface(const Surface& surface, const std::vector<float>& stock, ScenePart& part);

/** Adds the faces of \p mesh, cut into pieces that are no longer than a hundredth of it; fewer if they were more than \p most. */
void addMesh(const SurfaceMesh& mesh, std::size_t most, ScenePart& part);

/** Merges places until there are at most \p most. Of those merged, the worst stock is kept. Returns how far merged places may have been
 *  apart; 0: all are kept. */
double thinPart(std::size_t most, ScenePart& part);

} // namespace pcl_spiral
