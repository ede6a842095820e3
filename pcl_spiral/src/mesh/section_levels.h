// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the planes of section passes lie. Private to mesh.
 */
#pragma once

#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** How far each vertex lies along the planes' normal, and from where to where they all do. */
struct MeshExtent {
  std::vector<double> of;
  double low = 0.0, high = 0.0;
};

MeshExtent extentAlong(const SurfaceMesh& mesh, const Eigen::Vector3d& normal);

/** The planes of \p settings: given, even, or kept to the scallop. Refused where none crosses the mesh, where it has no extent, or
 *  where rows and contacts would be too many. */
Status sectionLevels(const SurfaceMesh& mesh, const SectionSettings& settings, const MeshExtent& extent, std::vector<double>& levels,
                     SectionReport& report);

} // namespace pcl_spiral
