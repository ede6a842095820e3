// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines of a mesh's faces with parallel planes. Private to mesh.
 */
#pragma once

#include "graph/level_lines.h"
#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** Lines of each of ascending \p levels of the distance along \p normal (unit): the faces found as \p search sets, joined from
 *  face to face. \p distances has that of each vertex. */
std::vector<std::vector<LevelLine>> sectionLines(const SurfaceMesh& mesh, const Eigen::Vector3d& normal,
                                                 const std::vector<double>& distances, const std::vector<double>& levels,
                                                 MeshSearch search);

} // namespace pcl_spiral
