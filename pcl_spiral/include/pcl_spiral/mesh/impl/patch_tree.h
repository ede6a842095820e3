// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Curved triangles in a tree of boxes; they can be divided into smaller ones.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/search/impl/box_tree.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Part of a curved triangle, which is a curved triangle too: a quarter of a quarter and so on. In barycentric coordinates
 *  its edges are parallel to those of the whole, so its bows are those of the whole divided by four at each halving. */
struct PatchCell {
  Eigen::Matrix3d corners;                               ///< one per column
  Eigen::Matrix3d bows;                                  ///< one per column, as in MeshPatch
  Eigen::Matrix3d weights = Eigen::Matrix3d::Identity(); ///< of the corners in the whole, one per column

  /** The place at barycentric coordinates \p b of this part. */
  Eigen::Vector3d position(const Eigen::Vector3d& b) const
  {
    return corners * b - bows * Eigen::Vector3d(b[0] * b[1], b[1] * b[2], b[2] * b[0]);
  }
  /** Bound of how far it may be from the flat triangle of its corners. \see SurfaceMesh::sag */
  double sag() const { return std::sqrt(bows.colwise().squaredNorm().maxCoeff()) / 3.0; }
  /** Quarter \p k of 0 to 3; the last one is the middle. */
  PatchCell quarter(int k) const;
};

/** A place found on the patches. */
struct PatchPlace {
  std::uint32_t patch = 0; ///< index as given
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double distance = 0.0;
};

/** Barycentric coordinates of the place of a flat triangle nearest to \p p. */
Eigen::Vector3d nearestOnTriangle(const Eigen::Matrix3d& corners, const Eigen::Vector3d& p);

/** Curved triangles in a tree of their boxes. Memory: about 200 bytes each. */
class PatchTree {
public:
  PatchTree() = default;
  /** Patches are identified by their index in \p cells. */
  explicit PatchTree(const std::vector<PatchCell>& cells);

  const BoxTree& boxes() const { return tree_; }
  std::size_t size() const { return tree_.size(); }
  /** Index, as given, of the patch at \p place in tree order. */
  std::uint32_t index(std::size_t place) const { return tree_.item(place); }
  PatchCell cell(std::size_t place) const { return {shapes_[place].corners, shapes_[place].bows}; }

  /** The place nearest to \p p, if one is within \p distance, accurate to \p sag. If several are equally near: that of the lowest index. */
  bool nearest(const Eigen::Vector3d& p, double distance, double sag, PatchPlace& place) const;

private:
  struct Shape {
    Eigen::Matrix3d corners, bows;
  };
  std::vector<Shape> shapes_; ///< in tree order
  BoxTree tree_;
};

/** The faces of \p mesh, by their index. */
PatchTree facesOf(const SurfaceMesh& mesh);

/** The boundary edges of \p mesh as triangles without width. */
PatchTree rimOf(const SurfaceMesh& mesh);

} // namespace pcl_spiral
