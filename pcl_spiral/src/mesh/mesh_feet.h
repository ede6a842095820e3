// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The place of a mesh nearest to any place.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** Foot of a place on the curved surface of a mesh. */
struct MeshFoot {
  std::uint32_t face = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric, in the face
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit, out of the material
  double distance = 0.0;                            ///< of the place from it, mm
  bool beyond = false;                              ///< it lies on the boundary of the mesh: the place may be beside the mesh
};

/** Finds feet. Safe to use from several threads at once. The mesh must outlive it. */
class MeshFeet {
public:
  explicit MeshFeet(const SurfaceMesh& mesh) : mesh_(mesh), faces_(facesOf(mesh)) {}

  MeshFoot of(const Eigen::Vector3d& place) const;

private:
  const SurfaceMesh& mesh_;
  PatchTree faces_;
};

} // namespace pcl_spiral
