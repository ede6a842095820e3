// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A triangle mesh and the curved surface behind it.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/mesh/impl/mesh_settings.h>

#include <pcl/PolygonMesh.h>

#include <cstdint>
#include <memory>

namespace pcl_spiral {

/** The curved triangle spanned by the parabolas of three edges: with barycentric coordinates b,
 *  x(b) = sum b_i P_i - sum bow_ij b_i b_j. Its edges are the parabolas; it is flat where the bows are zero. */
struct MeshPatch {
  Eigen::Matrix3d corners; ///< one per column
  Eigen::Matrix3d bows;    ///< one per column: of the edges from corner 0 to 1, 1 to 2, 2 to 0
  Eigen::Matrix3d normals; ///< one per column: unit, at the corners, out of the material

  Eigen::Vector3d position(const Eigen::Vector3d& b) const
  {
    return corners * b - bows * Eigen::Vector3d(b[0] * b[1], b[1] * b[2], b[2] * b[0]);
  }
  /** Interpolated between the normals of the corners, unit. */
  Eigen::Vector3d normal(const Eigen::Vector3d& b) const { return (normals * b).normalized(); }
};

/** A prepared triangle mesh. Vertices are welded; faces without area and repeated
 *  faces are left out; the others are turned to one side. The curved surface behind
 *  the flat faces has a normal per corner and a bow per edge. Immutable, shared by
 *  all stages that take a mesh. Lengths in mm. Memory: about 150 bytes per face. */
class SurfaceMesh {
public:
  using ConstPtr = std::shared_ptr<const SurfaceMesh>;

  /** Makes it from \p mesh, whose cloud has the fields x, y, z. Neighbouring faces are turned the same way, each part as most of its
   *  area was. A closed mesh that then encloses a negative volume is turned inside out. \p result is null on failure: no points, no
   *  faces, an index that is not one of a point, a corner that is not finite, no face with an area, a setting out of range. */
  static Status make(const pcl::PolygonMesh& mesh, const MeshSettings& settings, ConstPtr& result);

  const MeshSettings& settings() const { return settings_; }
  const MeshCounts& counts() const { return counts_; }

  const Triangulation& triangles() const { return triangles_; }
  std::size_t vertexCount() const { return positions_.size(); }
  std::size_t faceCount() const { return triangles_.triangleCount(); }
  const Eigen::Vector3d& position(std::size_t v) const { return positions_[v]; }
  /** Normal of face \p t as it is, unit, out of the material. */
  Eigen::Vector3d faceNormal(std::size_t t) const;
  double faceArea(std::size_t t) const;
  /** Unit normal of the surface at the origin of half-edge \p h, on the side
   *  of its face: next to a crease, a vertex has one normal on each side. */
  const Eigen::Vector3d& normal(std::uint32_t h) const { return normals_[sector_of_[h]]; }
  /** Number of the normal at the corner of half-edge \p h: corners at a vertex share it, except across creases. */
  std::uint32_t sector(std::uint32_t h) const { return sector_of_[h]; }
  std::size_t sectorCount() const { return normals_.size(); }
  /** Bow of the edge of half-edge \p h; see parabola_edge.h. The same for both half-edges. */
  const Eigen::Vector3d& bow(std::uint32_t h) const { return bows_[h]; }
  /** Whether the edge of half-edge \p h is a crease. */
  bool isCrease(std::uint32_t h) const { return creases_[h] != 0; }
  MeshPatch patch(std::size_t t) const;
  /** Bound of how far the curved surface of face \p t may be from the flat face. */
  double sag(std::size_t t) const;

  double area() const { return area_; }
  /** Mean of the normals of the faces, weighted by area, not of unit length: zero on a closed mesh. */
  const Eigen::Vector3d& meanNormal() const { return mean_normal_; }

private:
  void shape();
  void findCreases();
  void countEdges();
  void setBow(std::uint32_t h);

  MeshSettings settings_;
  MeshCounts counts_;
  Triangulation triangles_;
  std::vector<Eigen::Vector3d> positions_, normals_, bows_;
  std::vector<std::uint32_t> sector_of_; ///< of the corner of each half-edge: index of its normal
  std::vector<std::uint8_t> creases_;
  double area_ = 0.0;
  Eigen::Vector3d mean_normal_ = Eigen::Vector3d::Zero();
};

} // namespace pcl_spiral
