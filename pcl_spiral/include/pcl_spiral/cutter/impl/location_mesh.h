/** \file
 *  A mesh as cutters are located on it.
 */
#pragma once

#include <pcl_spiral/mesh/impl/patch_tree.h>

namespace pcl_spiral {

/** The faces of a mesh and its boundary edges, ready to be found. Lengths in mm. Memory: about 200 bytes a face, beside the
 *  mesh. */
class LocationMesh {
public:
  explicit LocationMesh(const SurfaceMesh::ConstPtr& mesh);
  LocationMesh(const LocationMesh&) = delete; // shared
  LocationMesh& operator=(const LocationMesh&) = delete;

  const SurfaceMesh::ConstPtr&
  mesh() const
  {
    return mesh_;
  }
  const PatchTree&
  faces() const
  {
    return faces_;
  }
  /** Boundary edges: beyond them nothing is known. */
  const PatchTree&
  rim() const
  {
    return rim_;
  }
  /** The rounding of coordinates: two steps of single precision. */
  double
  rounding() const
  {
    return rounding_;
  }

private:
  SurfaceMesh::ConstPtr mesh_;
  PatchTree faces_, rim_;
  double rounding_ = 0.0;
};

} // namespace pcl_spiral
