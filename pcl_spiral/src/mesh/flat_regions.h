// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Flat faces of a mesh that is round beside them. Private to mesh.
 */
#pragma once

#include "corner_sectors.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Faces joined where they lie in one plane, not across creases. A mesher keeps the distance of its faces from the surface about
 *  constant, so where a surface bends, the sizes of its faces change slowly. A region much wider than what lies beyond its rim is
 *  therefore flat, and its rim is where the surface begins to bend. */
struct FlatRegions {
  std::vector<std::uint32_t> of_face;   ///< the region of each face
  std::vector<Eigen::Vector3d> normals; ///< of each region, unit
  std::vector<std::uint8_t> flat;       ///< of each region: two faces or more, much wider than what lies beyond half of its rim

  /** Whether the edge of half-edge \p h is between faces of one region. */
  bool isInside(const Triangulation& mesh, std::uint32_t h) const
  {
    const std::uint32_t other = mesh.opposite(h);
    return other != Triangulation::none && of_face[other / 3] == of_face[h / 3];
  }
  /** The flat region of \p face, or none. */
  std::uint32_t flatAt(std::uint32_t face) const { return flat[of_face[face]] ? of_face[face] : Triangulation::none; }
};

FlatRegions flatRegions(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions, const std::vector<std::uint8_t>& creases);

/** Adds to \p creases the edges where two flat regions meet: nothing round is between them. */
void addFlatCreases(const Triangulation& mesh, const FlatRegions& regions, std::vector<std::uint8_t>& creases);

/** Where fits stop: at \p creases, and where a flat region meets what bends. */
std::vector<std::uint8_t> fitLimits(const Triangulation& mesh, const FlatRegions& regions, const std::vector<std::uint8_t>& creases);

/** Gives each of the \p sectors' \p normals at a flat region that region's normal: what bends beside it begins with the same normal. */
void takeFlatNormals(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions, const CornerSectors& sectors,
                     const FlatRegions& regions, std::vector<Eigen::Vector3d>& normals);

} // namespace pcl_spiral
