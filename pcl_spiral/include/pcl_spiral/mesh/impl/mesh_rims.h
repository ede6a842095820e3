// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The boundary of a mesh, or of some of its faces, as closed curves.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A closed boundary; the faces are on its left, seen from outside the material. */
struct MeshRim {
  std::vector<std::uint32_t> half_edges; ///< of the mesh, in order
  double length = 0.0;                   ///< mm, of the curved edges
};

/** Boundaries of the faces for which \p chosen is not 0; empty: of all faces. The longest is first. */
std::vector<MeshRim> meshRims(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen = {});

/** Place at \p u, from 0 to 1, of the curved edge of half-edge \p h. */
Eigen::Vector3d edgePlace(const SurfaceMesh& mesh, std::uint32_t h, double u);

/** Places along the curved edges of \p rim, no farther apart than
 *  \p step, including every vertex; the first place is not repeated. */
Polyline rimCurve(const SurfaceMesh& mesh, const MeshRim& rim, double step);

} // namespace pcl_spiral
