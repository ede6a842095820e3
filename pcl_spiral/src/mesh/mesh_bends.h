// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Curvature of the surface that a mesh represents. Private to mesh.
 */
#pragma once

#include "core/row_distance.h"
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** Normal and principal curvatures at each sector of the mesh (SurfaceMesh::sector): from the change of the normals over its faces,
 *  a mean weighted by their areas. */
std::vector<SurfaceBend> meshBends(const SurfaceMesh& mesh);

} // namespace pcl_spiral
