// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "toolpath_rows.h"

#include <pcl_spiral/io/toolpath_writer.h>

namespace pcl_spiral {

void
writeToolpathPLY(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const Eigen::Vector3d& origin)
{
  ByteFile out(file);
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment toolpath, mm: contact, normal, tool axis\n"
                       "element vertex " +
                       std::to_string(path.size()) + "\n";
  for (const char* name : {"x", "y", "z"})
    header += std::string(origin.isZero() ? "property float " : "property double ") + name + "\n";
  for (const char* name : {"nx", "ny", "nz", "axis_x", "axis_y", "axis_z"})
    header += std::string("property float ") + name + "\n";
  out.write(header + "property double arc_length\nproperty float turn\nproperty uchar over_gap\nproperty float lift\nend_header\n");
  out.write(toolpathRows(path, origin));
  out.close();
}

} // namespace pcl_spiral
