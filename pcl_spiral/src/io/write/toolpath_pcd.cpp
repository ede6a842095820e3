// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "toolpath_rows.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <pcl/io/pcd_io.h>

namespace pcl_spiral {

// PCL makes the header; the points are written here, because on a full disk PCL's writer prints only a message on the
// console that a user cannot understand.

void
writeToolpathPCD(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path)
{
  if (path.empty())
    throw FileError(file, "not written: the path has no points");
  ByteFile out(file);
  out.write(pcl::PCDWriter::generateHeader(path) + "DATA binary\n");
  out.write(toolpathRows(path));
  out.close();
}

} // namespace pcl_spiral
