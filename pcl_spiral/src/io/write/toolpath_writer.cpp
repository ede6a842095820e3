// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <stdexcept>

namespace pcl_spiral {

const std::vector<std::string>&
toolpathExtensions()
{
  static const std::vector<std::string> extensions{".csv", ".pcd", ".ply", ".vtp"};
  return extensions;
}

void
writeToolpath(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion, const PathValues& values)
{
  if (path.empty())
    throw FileError(file, "not written: the path has no points");
  if (!motion.tips.empty() && motion.tips.size() != path.size())
    throw std::invalid_argument(std::to_string(motion.tips.size()) + " tips for " + std::to_string(path.size()) +
                                " path points; give one tip per point");
  const std::string extension = lowerExtension(file);
  if (extension == ".csv")
    writeToolpathCSV(file, path, motion);
  else if (extension == ".pcd")
    writeToolpathPCD(file, path, motion.origin);
  else if (extension == ".ply")
    writeToolpathPLY(file, path, motion.origin);
  else if (extension == ".vtp")
    writeToolpathVTP(file, path, motion, values);
  else
    throw FileError(file, Diagnostic("extension '", extension, "' is not known for a toolpath; use .csv, .pcd, .ply or .vtp"));
}

} // namespace pcl_spiral
