/** \file
 *  How a triangle mesh is taken for a surface, and what was found in it.
 */
#pragma once

#include <pcl_spiral/core/impl/parabola_edge.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Where the normals of a mesh's vertices come from. */
enum class MeshNormals {
  AreaWeighted, ///< mean of the faces' normals by their areas; equation (2) of Sun, Li, Li, Liu, 2010
  Max,          ///< mean by sin(angle) / (product of both edges): exact on spheres. Max, Weights for computing vertex normals
                ///< from facet normals, Journal of Graphics Tools 4(2), 1999
  Fitted        ///< of a cubic surface fitted to two rings of neighbours; Max where these do not determine one
};

/** Lengths in mm, angles in degrees. */
struct MeshSettings {
  MeshNormals normals = MeshNormals::Fitted;
  MeshEdges edges = MeshEdges::Robust;
  double crease_angle = 30.0; ///< an edge bent by more is a crease: neither normals nor parabolas go across it. But narrow faces that
                              ///< stand up by no more than noise, or than the mesh's own error, make none
  bool flip = false;          ///< turn all faces to the other side
};

/** Something found in a mesh: how often, and where first. */
struct MeshFinding {
  std::size_t count = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();

  void
  add(const Eigen::Vector3d& where)
  {
    if (count++ == 0)
      place = where;
  }
};

/** What was found in a mesh and done about it. */
struct MeshCounts {
  std::size_t given_faces = 0; ///< of the input, polygons cut into triangles
  MeshFinding welded;          ///< vertices at the place of an earlier one
  MeshFinding without_area;    ///< faces left out: corners in one place or on one line
  MeshFinding repeated;        ///< faces left out: the same corners as an earlier one
  MeshFinding turned;          ///< faces that faced the other way than their neighbours
  MeshFinding crowded_edges;   ///< edges of more than two faces; two of the faces stay joined there
  MeshFinding one_sided_edges; ///< of a surface with one side alone, as a Moebius strip has: cut there
  MeshFinding open_edges;      ///< on the boundary
  MeshFinding creases;         ///< edges bent by more than the crease angle, and not by noise alone
  MeshFinding limited;         ///< edges whose correction would be more than a quarter of their length: left straight
  MeshFinding other_normals;   ///< vertices with normals by Max where fitted ones were asked for
  double crease_length = 0.0;  ///< mm
  std::size_t vertices = 0, faces = 0, parts = 0, loops = 0;
  double noise = 0.0;          ///< of the vertices about the surface, mm: a crease stands higher
  bool closed = false;         ///< no open edges
  bool inside_out = false;     ///< a closed mesh whose faces all faced inwards: turned
};

} // namespace pcl_spiral
