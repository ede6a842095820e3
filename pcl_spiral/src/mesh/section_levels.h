// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where the planes of section passes lie. Private to mesh.
 */
#pragma once

#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** How far each vertex lies along the normal of the planes, and the range of these values. */
struct MeshExtent {
  std::vector<double> of;
  double low = 0.0, high = 0.0;
};

MeshExtent extentAlong(const SurfaceMesh& mesh, const Eigen::Vector3d& normal);

/** The planes of \p settings: given, even, or set by the scallop height. Refused if none crosses the mesh, if it has no extent, or
 *  if rows and contacts would be too many. */
Status sectionLevels(const SurfaceMesh& mesh, const SectionSettings& settings, const MeshExtent& extent, std::vector<double>& levels,
                     SectionReport& report);

} // namespace pcl_spiral
