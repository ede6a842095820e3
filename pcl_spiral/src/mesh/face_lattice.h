// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places spread over one face of a mesh. Private to mesh.
 */
#pragma once

#include <pcl_spiral/mesh/surface_mesh.h>

#include <cstddef>
#include <cstdint>

namespace pcl_spiral {

/** Columns of places over the longest side of a face, none on its edges. Whatever the face's shape, every place of the face
 *  has one within 1.45 steps. The same whichever corner the face begins with. */
class FaceLattice {
public:
  FaceLattice(const SurfaceMesh& mesh, std::size_t face, double step);

  std::size_t columns() const { return columns_; }
  std::size_t rows(std::size_t column) const;
  std::size_t count() const;
  /** Shares of the corners of patch(). */
  Eigen::Vector3d place(std::size_t column, std::size_t row) const;
  /** The face's patch, its corners from the start of the longest side on. */
  const MeshPatch& patch() const { return patch_; }

private:
  /** The face's height over a place of the longest side, as a share of the largest. */
  double heightShare(double u) const;

  MeshPatch patch_;
  double step_, height_, apex_; ///< share of the longest side below the corner across
  std::size_t columns_;
};

} // namespace pcl_spiral
