#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <pcl/io/pcd_io.h>

namespace pcl_spiral {

void
writeToolpathPCD(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path)
{
  if (path.empty())
    throw FileError(file, "not written: the path has no points");
  try {
    if (pcl::PCDWriter().writeBinary(file, path) < 0)
      throw FileError(file, "cannot be written");
  }
  catch (const pcl::IOException& error) {
    throw FileError(file, std::string("cannot be written: ") + error.what());
  }
}

} // namespace pcl_spiral
