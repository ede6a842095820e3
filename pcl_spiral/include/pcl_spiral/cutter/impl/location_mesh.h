// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh prepared for locating cutters on it.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>

namespace pcl_spiral {

/** The faces and boundary edges of a mesh, prepared for searching.
 *  Lengths in mm. Memory: about 200 bytes per face, plus the mesh. */
class LocationMesh {
public:
  explicit LocationMesh(const SurfaceMesh::ConstPtr& mesh);
  LocationMesh(const LocationMesh&) = delete; // shared
  LocationMesh& operator=(const LocationMesh&) = delete;

  const SurfaceMesh::ConstPtr& mesh() const { return mesh_; }
  const PatchTree& faces() const { return faces_; }
  /** Boundary edges: beyond them nothing is known. */
  const PatchTree& rim() const { return rim_; }
  /** Rounding of the coordinates: two steps of single precision. */
  double rounding() const { return rounding_; }

private:
  SurfaceMesh::ConstPtr mesh_;
  PatchTree faces_, rim_;
  double rounding_ = 0.0;
};

} // namespace pcl_spiral
