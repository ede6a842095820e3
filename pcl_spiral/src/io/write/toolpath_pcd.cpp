// SPDX-License-Identifier: BSD-3-Clause
#include "common/formatted_text.h"
#include "io/byte_file.h"
#include "io/pcd_origin.h"
#include "toolpath_rows.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <pcl/io/pcd_io.h>

namespace pcl_spiral {

// PCL makes the header; the points are written here, because on a full disk PCL's writer prints only a message on the
// console that a user cannot understand.

void
writeToolpathPCD(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const Eigen::Vector3d& origin)
{
  if (path.empty())
    throw FileError(file, "not written: the path has no points");
  ByteFile out(file);
  std::string header = pcl::PCDWriter::generateHeader(path);
  if (!origin.isZero()) // below the first line, by which programs know the format
    header.insert(header.find('\n') + 1, pcd_origin_mark + formatted("%.17g %.17g %.17g\n", origin.x(), origin.y(), origin.z()));
  out.write(header + "DATA binary\n");
  out.write(toolpathRows(path));
  out.close();
}

} // namespace pcl_spiral
