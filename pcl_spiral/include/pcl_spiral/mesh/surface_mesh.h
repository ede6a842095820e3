// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A triangle mesh and the curved surface behind it.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <pcl/PolygonMesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Shape of the edges of a mesh. */
enum class MeshEdges {
  Straight,  ///< straight lines: plain sections
  Published, ///< parabola from the meeting point of the edge's projections, equation (3) of Sun, Li, Li, Liu
  Robust     ///< parabola from the mean of the slopes at both ends along the mean normal
};

/** Where the normals of the vertices of a mesh come from. */
enum class MeshNormals {
  AreaWeighted, ///< mean of the faces' normals, weighted by area; equation (2) of Sun, Li, Li, Liu, 2010
  Max,          ///< mean by sin(angle) / (product of both edges): exact on spheres. Max, Weights for computing vertex normals
                ///< from facet normals, Journal of Graphics Tools 4(2), 1999
  Fitted        ///< of a cubic surface fitted to two rings of neighbours; Max if these do not determine one
};

/** Settings of a mesh. Lengths in mm, angles in degrees. */
struct MeshSettings {
  MeshNormals normals = MeshNormals::Fitted; ///< how vertex normals are found
  MeshEdges edges = MeshEdges::Robust;       ///< how edges are bent
  double crease_angle = 30.0; ///< an edge bent by more is a crease: normals and parabolas do not go across it. Exception: narrow
                              ///< faces that stand up by no more than noise, or no more than the error of the mesh itself
  bool flip = false;          ///< turn all faces to the other side
};

/** All but the ways to find normals and edges. */
std::vector<Setting> settingTable(MeshSettings& settings);

/** Something found in a mesh: how many times, and where first. */
struct MeshFinding {
  std::size_t count = 0;                           ///< how many times
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< where first, mm

  /** Counts one more, \p where it is. */
  void add(const Eigen::Vector3d& where)
  {
    if (count++ == 0)
      place = where;
  }
};

/** What was found in a mesh and corrected. */
struct MeshReport {
  std::size_t given_faces = 0; ///< of the input, with polygons cut into triangles
  MeshFinding welded;          ///< vertices at the place of an earlier one
  MeshFinding without_area;    ///< faces left out: two corners at one place, or all on one line
  MeshFinding repeated;        ///< faces left out: the same corners as an earlier face
  MeshFinding turned;          ///< faces that faced the other way from their neighbours
  MeshFinding crowded_edges;   ///< edges of more than two faces; two of the faces stay joined there
  MeshFinding one_sided_edges; ///< of a surface with only one side, such as a Moebius strip: cut there
  MeshFinding open_edges;      ///< on the boundary
  MeshFinding creases;         ///< edges bent by more than the crease angle, and not only by noise
  MeshFinding limited;         ///< edges whose correction would be more than a quarter of their length: left straight
  MeshFinding other_normals;   ///< vertices with normals by Max although fitted ones were asked for
  double crease_length = 0.0;  ///< mm
  std::size_t vertices = 0;    ///< of the prepared mesh
  std::size_t faces = 0;       ///< of the prepared mesh
  std::size_t parts = 0;       ///< connected by edges
  std::size_t loops = 0;       ///< closed boundaries
  double noise = 0.0;          ///< of the vertices about the surface, mm: a crease must stand higher
  bool closed = false;         ///< no open edges
  bool inside_out = false;     ///< a closed mesh whose faces all faced inwards: turned
};

/** \deprecated Use MeshReport. */
using MeshCounts [[deprecated("use MeshReport")]] = MeshReport;

/** The curved triangle spanned by the parabolas of three edges: with barycentric coordinates b,
 *  x(b) = sum b_i P_i - sum bow_ij b_i b_j. Its edges are the parabolas; it is flat where the bows are zero. */
struct MeshPatch {
  Eigen::Matrix3d corners; ///< one per column
  Eigen::Matrix3d bows;    ///< one per column: of the edges from corner 0 to 1, 1 to 2, 2 to 0
  Eigen::Matrix3d normals; ///< one per column: unit, at the corners, out of the material

  /** The place at barycentric coordinates \p b. */
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
  using ConstPtr = std::shared_ptr<const SurfaceMesh>; ///< A shared pointer to a constant one.

  /** Makes it from \p mesh, whose cloud has the fields x, y, z. Neighbouring faces are turned the same way, each part as most of its
   *  area was. A closed mesh that then encloses a negative volume is turned inside out. \p result is null on failure: no points, no
   *  faces, an index that is not one of a point, a corner that is not finite, no face with an area, a setting out of range. */
  static Status make(const pcl::PolygonMesh& mesh, const MeshSettings& settings, ConstPtr& result);

  const MeshSettings& settings() const { return settings_; }                         ///< The settings it was made with.
  const MeshReport& report() const { return counts_; }                               ///< What was found and corrected.
  [[deprecated("use report")]] const MeshReport& counts() const { return report(); } ///< \deprecated Use report.

  const Triangulation& triangles() const { return triangles_; }                  ///< Faces, their neighbours and half-edges.
  std::size_t vertexCount() const { return positions_.size(); }                  ///< Number of vertices.
  std::size_t faceCount() const { return triangles_.triangleCount(); }           ///< Number of faces.
  const Eigen::Vector3d& position(std::size_t v) const { return positions_[v]; } ///< Vertex \p v.
  /** Normal of face \p t as it is, unit, out of the material. */
  Eigen::Vector3d faceNormal(std::size_t t) const;
  double faceArea(std::size_t t) const; ///< Area of face \p t as it is, mm^2.
  /** Unit normal of the surface at the origin of half-edge \p h, on the side
   *  of its face: next to a crease, a vertex has one normal on each side. */
  const Eigen::Vector3d& normal(std::uint32_t h) const { return normals_[sector_of_[h]]; }
  /** Number of the normal at the corner of half-edge \p h: corners at a vertex share it, except across creases. */
  std::uint32_t sector(std::uint32_t h) const { return sector_of_[h]; }
  std::size_t sectorCount() const { return normals_.size(); } ///< Number of different normals at corners.
  /** Bow of the edge of half-edge \p h; see parabola_edge.h. The same for both half-edges. */
  const Eigen::Vector3d& bow(std::uint32_t h) const { return bows_[h]; }
  /** Whether the edge of half-edge \p h is a crease. */
  bool isCrease(std::uint32_t h) const { return creases_[h] != 0; }
  /** Whether face \p t is part of a flat region beside faces that bend: its curved surface is the face itself. */
  bool isFlat(std::size_t t) const { return flat_[t] != 0; }
  MeshPatch patch(std::size_t t) const; ///< The curved surface behind face \p t.
  /** Bound of how far the curved surface of face \p t may be from the flat face. */
  double sag(std::size_t t) const;

  double area() const { return area_; } ///< Of all faces as they are, mm^2.
  /** Mean of the normals of the faces, weighted by area, not of unit length: zero on a closed mesh. */
  const Eigen::Vector3d& meanNormal() const { return mean_normal_; }

private:
  void shape();
  void findCreases();
  void countEdges();
  void setBow(std::uint32_t h);

  MeshSettings settings_;
  MeshReport counts_;
  Triangulation triangles_;
  std::vector<Eigen::Vector3d> positions_, normals_, bows_;
  std::vector<std::uint32_t> sector_of_; ///< of the corner of each half-edge: index of its normal
  std::vector<std::uint8_t> creases_, flat_;
  double area_ = 0.0;
  Eigen::Vector3d mean_normal_ = Eigen::Vector3d::Zero();
};

} // namespace pcl_spiral
