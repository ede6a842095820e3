// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of meshes.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/cloud_reader.h>

#include <pcl/PolygonMesh.h>

#include <cstddef>

namespace pcl_spiral {

/** A mesh in mm. */
struct MeshFile {
  pcl::PolygonMesh::Ptr mesh;                      ///< triangles over points x y z
  std::size_t polygons = 0;                        ///< faces of more than three corners; they were cut into triangles
  Diagnostics warnings;                            ///< what the reader found and did not change
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< mm, see Scan::shift
};

/** Extensions that readMesh accepts, with the dot. */
const std::vector<std::string>& meshExtensions();

/** Reads vertices and faces of a .stl (ascii or binary), .obj, or .ply (ascii or binary, element face).
 *
 *  Vertices are those that readCloud gives, in the same order. For STL, vertices whose coordinates agree in all
 *  bits are one vertex. Vertices that no face uses stay. Faces keep their order and their sense of rotation.
 *  Convex polygons are cut as a fan from their first corner, others by ears in their mean plane, so that the
 *  triangles do not overlap. Where that is not possible, a warning reports the first polygon that crosses
 *  itself or is flat. Faces without area and repeated faces stay. Textures, normals and groups are ignored.
 *  \p options: unit and origin as for readCloud, with its warnings; no columns.
 *  \throw FileError with the line, byte or face, and the remedy: as readCloud, and for no faces,
 *  a face of fewer than three corners, a vertex that does not exist, a face with a vertex that
 *  is not finite, triangle strips, a polygon of more than 20,000 corners that is not convex */
MeshFile readMesh(const std::string& file, const ReadOptions& options = {});

} // namespace pcl_spiral
