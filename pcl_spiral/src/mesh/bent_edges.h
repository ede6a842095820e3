// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Edges of a mesh that bend sharply, and whether the part bends there. Private to mesh.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** For each half-edge whether its faces are bent by more than the crease angle. */
std::vector<std::uint8_t> bentEdges(const SurfaceMesh& mesh);

/** Whether the part itself is bent at a bent edge. Narrow faces bend sharply on smooth parts, too, if one of their corners lies
 *  beside a long edge: then the face beyond the narrow one continues the wide one, and the narrow one stands up by no more
 *  than four times the error of the mesh there: the standard deviation of the vertices' \p noise, and the sag of its longest
 *  edge on the curvature about it. */
bool standsOut(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& bent, double noise, std::uint32_t h);

} // namespace pcl_spiral
