// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Faces of a file: polygons over numbered vertices.
 */
#pragma once

#include "point_table.h"

#include <cstdint>

namespace pcl_spiral {

/** Corners of all faces in sequence, each face with its place in the file. */
struct FaceList {
  std::vector<std::int64_t> corners; ///< vertices counted from 0; not yet checked
  std::vector<std::size_t> ends;     ///< for each face, the end of its corners
  std::vector<std::size_t> places;   ///< for each face, its line or byte
  const char* place_word = "line";
  std::int64_t first_vertex = 0; ///< number of the first vertex in the file

  std::size_t begin(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  /** Corners added since the last close. */
  std::size_t open() const { return corners.size() - begin(ends.size()); }
  /** Makes a face of the corners added since the last close. */
  void close(std::size_t place)
  {
    ends.push_back(corners.size());
    places.push_back(place);
  }
  /** "face 3 (line 17)" */
  std::string nameOf(std::size_t face) const
  {
    return "face " + std::to_string(face + 1) + " (" + place_word + " " + std::to_string(places[face]) + ")";
  }
};

/** Content of a mesh file. */
struct MeshTable {
  PointTable vertices;
  FaceList faces;
};

/** Vertices, the same as in the tables of points, and faces. \throw FileError as the readers of tables, and if
 * a face cannot be read
 *  @{ */
MeshTable readStlMesh(const std::string& file, std::string_view bytes);
MeshTable readObjMesh(const std::string& file, std::string_view bytes);
MeshTable readPlyMesh(const std::string& file, std::string_view bytes);
/** @} */

} // namespace pcl_spiral
