// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Small mesh files: the four corners of a tetrahedron, and two faces.
 */
#pragma once

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl_spiral {

using Triangles = std::vector<std::array<int, 3>>;

/** The corners of a tetrahedron, and two faces over the first three and the last. */
inline const std::vector<Eigen::Vector3f> corners{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10.5}};
inline const Triangles two_faces{{0, 2, 1}, {0, 1, 3}};

inline const std::string obj_corners = "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10.5\n";
inline const std::string ply_vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
inline const std::string ply_faces = "element face 2\nproperty list uchar int vertex_indices\n";
inline const std::string ply_rows = "0 0 0\n10 0 0\n0 10 0\n0 0 10.5\n";
inline const std::string ascii = "ply\nformat ascii 1.0\n";

/** The bytes of a value, in the other order if swapped. */
template <typename T>
std::string
bytesOf(T value, bool swapped)
{
  std::string raw(sizeof(T), '\0');
  std::memcpy(&raw[0], &value, sizeof(T));
  if (swapped)
    std::reverse(raw.begin(), raw.end());
  return raw;
}

/** Facets over the corners; binary. */
inline std::string
binaryStl(const Triangles& faces)
{
  std::string bytes(80, ' ');
  bytes += bytesOf(static_cast<std::uint32_t>(faces.size()), false);
  for (const auto& face : faces) {
    bytes += std::string(12, '\0');
    for (const int corner : face)
      for (int c = 0; c < 3; ++c)
        bytes += bytesOf(corners[static_cast<std::size_t>(corner)][c], false);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

/** A facet of an ascii file with these rows of vertices. */
inline std::string
facet(const std::string& rows)
{
  return "facet normal 0 0 1\nouter loop\n" + rows + "endloop\nendfacet\n";
}

/** The error message of reading; empty if there is no error. */
inline std::string
problem(const std::string& file, const ReadOptions& options = {})
{
  try {
    readMesh(file, options);
  }
  catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/** Writes files and reads them. */
class MeshFiles : public ::testing::Test {
protected:
  std::string text(const std::string& name, const std::string& content)
  {
    writeText(folder_.path(name), content);
    return folder_.path(name);
  }
  void expectProblem(const std::string& name, const std::string& content, const std::string& words)
  {
    const std::string file = text(name, content), said = problem(file);
    EXPECT_NE(said.find(file), std::string::npos) << "names the file: " << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  ScratchFolder folder_;
};

} // namespace pcl_spiral
