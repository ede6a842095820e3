// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The smooth fans of faces about a mesh's vertices. Private to mesh.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Sectors: about each vertex, the faces joined there by edges that are no creases. Each corner of a face, named by
 *  the half-edge that leaves it, is in one sector. */
struct CornerSectors {
  std::vector<std::uint32_t> of_corner; ///< of each half-edge
  std::vector<std::uint32_t> begin;     ///< of each sector in corners, and the end
  std::vector<std::uint32_t> corners;   ///< half-edges, sector after sector, ascending in each

  std::size_t count() const { return begin.size() - 1; }
};

CornerSectors cornerSectors(const Triangulation& mesh, const std::vector<std::uint8_t>& creases);

} // namespace pcl_spiral
