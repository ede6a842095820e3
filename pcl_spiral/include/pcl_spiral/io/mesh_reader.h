/** \file
 *  Reader of meshes.
 */
#pragma once

#include <pcl_spiral/io/cloud_reader.h>

#include <pcl/PolygonMesh.h>

#include <cstddef>

namespace pcl_spiral {

/** A mesh in mm. */
struct MeshFile {
  pcl::PolygonMesh::Ptr mesh;        ///< triangles over points x y z
  std::size_t polygons = 0;          ///< faces of more than three corners, which were cut into triangles
  std::vector<std::string> warnings; ///< what the reader noticed and did not change
};

/** Extensions that readMesh knows, with the dot. */
const std::vector<std::string>& meshExtensions();

/** Vertices and faces of a .stl (ascii or binary), .obj, or .ply (ascii or binary, element face).
 *
 *  Vertices are those that readCloud gives, in the same order: those of STL once each, where all bits of the
 *  coordinates agree; vertices that no face uses stay. Faces keep their order and the sense in which they go round.
 *  Convex polygons are cut as a fan from their first corner, others by ears in their mean plane, so that the triangles
 *  do not overlap; a warning names the first one that crosses itself or is flat, where that cannot be kept. Faces
 *  without area and faces that are there twice stay. Textures, normals and groups are passed over.
 *  \p options: unit and origin as for readCloud, with its warnings; no columns.
 *  \throw FileError naming the line, byte or face, and the remedy: as readCloud, and for no faces, a face of fewer than
 *  three corners, a vertex that is not there, a face with a vertex that is not finite, triangle strips, a polygon of
 *  more than 20,000 corners that is not convex */
MeshFile readMesh(const std::string& file, const ReadOptions& options = {});

} // namespace pcl_spiral
