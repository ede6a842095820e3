// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How a triangle mesh is used as a surface, and what was found in it.
 */
#pragma once

#include <pcl_spiral/core/impl/parabola_edge.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Where the normals of the vertices of a mesh come from. */
enum class MeshNormals {
  AreaWeighted, ///< mean of the faces' normals, weighted by area; equation (2) of Sun, Li, Li, Liu, 2010
  Max,          ///< mean by sin(angle) / (product of both edges): exact on spheres. Max, Weights for computing vertex normals
                ///< from facet normals, Journal of Graphics Tools 4(2), 1999
  Fitted        ///< of a cubic surface fitted to two rings of neighbours; Max if these do not determine one
};

/** Settings of a mesh. Lengths in mm, angles in degrees. */
struct MeshSettings {
  MeshNormals normals = MeshNormals::Fitted;
  MeshEdges edges = MeshEdges::Robust;
  double crease_angle = 30.0; ///< an edge bent by more is a crease: normals and parabolas do not go across it. Exception: narrow
                              ///< faces that stand up by no more than noise, or no more than the error of the mesh itself
  bool flip = false;          ///< turn all faces to the other side
};

/** Something found in a mesh: how many times, and where first. */
struct MeshFinding {
  std::size_t count = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& where)
  {
    if (count++ == 0)
      place = where;
  }
};

/** What was found in a mesh and corrected. */
struct MeshCounts {
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
  std::size_t vertices = 0, faces = 0, parts = 0, loops = 0;
  double noise = 0.0;      ///< of the vertices about the surface, mm: a crease must stand higher
  bool closed = false;     ///< no open edges
  bool inside_out = false; ///< a closed mesh whose faces all faced inwards: turned
};

} // namespace pcl_spiral
