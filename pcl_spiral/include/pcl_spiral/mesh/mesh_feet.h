/** \file
 *  The place of a mesh nearest to any place.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>

#include <memory>

namespace pcl_spiral {

/** Where a place falls on a mesh. */
struct MeshFoot {
  std::uint32_t face = 0;
  Eigen::Vector3d share = Eigen::Vector3d::Zero();    ///< barycentric, of the flat face's point nearest to the place
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< there, on the curved surface
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< of the curved surface, unit, out of the material
  double distance = 0.0;                              ///< of the place from the flat face, mm
  bool beyond = false;                                ///< the nearest point lies on the mesh's boundary: the place is beside it
};

/** Finds feet by an R*-tree of the faces' boxes (Boost.Geometry). Safe to use from several threads at once. The mesh must outlive
 *  it. */
class MeshFeet {
public:
  explicit MeshFeet(const SurfaceMesh& mesh);
  ~MeshFeet();

  MeshFoot of(const Eigen::Vector3d& place) const;

private:
  struct Tree;
  const SurfaceMesh& mesh_;
  std::unique_ptr<const Tree> tree_;
};

} // namespace pcl_spiral
