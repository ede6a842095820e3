// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Faces of a mesh file made into one oriented surface. Private to mesh.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/PolygonMesh.h>

#include <vector>

namespace pcl_spiral {

/** Vertices, each place once, and the faces between them. */
struct WeldedFaces {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Triangulation::Triangle> faces;
};

/** Weld the corners of \p mesh, cut polygons into triangles, leave out faces without area and repeated ones. */
Status weldFaces(const pcl::PolygonMesh& mesh, WeldedFaces& welded, MeshReport& counts);

/** Turn faces so that neighbours face the same way. Each part faces as most of its area did. */
void turnFaces(WeldedFaces& welded, MeshReport& counts);

} // namespace pcl_spiral
