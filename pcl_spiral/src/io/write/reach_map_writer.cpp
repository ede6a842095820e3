// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/reach_map_writer.h>

#include "common/formatted_text.h"
#include "io/byte_file.h"
#include <pcl_spiral/io/file_error.h>

namespace pcl_spiral {
namespace {

std::string
headOf(const std::string& extension, std::size_t points)
{
  if (extension == ".csv")
    return "x,y,z,radius\n";
  if (extension == ".ply")
    return formatted("ply\nformat ascii 1.0\nelement vertex %zu\nproperty double x\nproperty double y\nproperty double z\n"
                     "property float radius\nend_header\n",
                     points);
  return formatted("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z radius\nSIZE 8 8 8 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH %zu\nHEIGHT 1\n"
                   "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %zu\nDATA ascii\n",
                   points, points);
}

} // namespace

void
writeReachMap(const std::string& file, const ReachMap& map, const Eigen::Vector3d& origin)
{
  const std::string extension = lowerExtension(file);
  if (extension != ".csv" && extension != ".pcd" && extension != ".ply")
    throw FileError(file, Diagnostic("extension '", extension, "' is not known for a map of balls; use .csv .pcd or .ply"));
  const char* const row = extension == ".csv" ? "%.6f,%.6f,%.6f,%.4f\n" : "%.6f %.6f %.6f %.4f\n";
  ByteFile out(file);
  out.write(headOf(extension, map.radii.size()));
  for (std::size_t i = 0; i < map.radii.size(); ++i) {
    const Eigen::Vector3d place = map.places[i] + origin;
    out.write(formatted(row, place.x(), place.y(), place.z(), map.radii[i]));
  }
  out.close();
}

} // namespace pcl_spiral
