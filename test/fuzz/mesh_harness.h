// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The rule for every fuzzed reader of meshes.
 */
#pragma once

#include "input_file.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>

#include <pcl/conversions.h>

namespace pcl_spiral {

/** Reads the bytes as a mesh: ends the program if the result is not a set of triangles over finite vertices, in
 *  proportion to the bytes, or if the vertices are not those of the scan. */
inline int
fuzzMesh(const std::string& extension, const std::uint8_t* data, std::size_t size)
{
  const InputFile file(extension, data, size);
  try {
    const MeshFile read = readMesh(file.name());
    const Scan scan = readCloud(file.name());
    pcl::PointCloud<pcl::PointXYZ> points;
    pcl::fromPCLPointCloud2(read.mesh->cloud, points);
    if (read.mesh->polygons.empty() || read.mesh->polygons.size() > size || points.size() != scan.cloud->size())
      std::abort();
    for (const pcl::Vertices& face : read.mesh->polygons) {
      if (face.vertices.size() != 3)
        std::abort();
      for (const auto corner : face.vertices)
        if (corner < 0 || static_cast<std::size_t>(corner) >= points.size() ||
            !points[static_cast<std::size_t>(corner)].getVector3fMap().allFinite())
          std::abort();
    }
  }
  catch (const FileError&) {
  }
  return 0;
}

} // namespace pcl_spiral
