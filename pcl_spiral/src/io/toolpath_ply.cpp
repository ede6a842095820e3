#include "byte_file.h"

#include <pcl_spiral/io/toolpath_writer.h>

#include <cstring>

namespace pcl_spiral {
namespace {

constexpr std::size_t bytes_a_point = 9 * sizeof(float) + sizeof(double) + sizeof(float) + 1;

template <typename T>
char*
put(char* out, T value)
{
  std::memcpy(out, &value, sizeof(T));
  return out + sizeof(T);
}

} // namespace

void
writeToolpathPLY(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path)
{
  ByteFile out(file);
  std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment toolpath, mm: contact, normal, tool axis\n"
      "element vertex " +
      std::to_string(path.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "axis_x", "axis_y", "axis_z"})
    header += std::string("property float ") + name + "\n";
  out.write(header + "property double arc_length\nproperty float turn\nproperty uchar over_gap\nend_header\n");

  std::string rows(path.size() * bytes_a_point, '\0');
  char* at = rows.data();
  for (const ToolpathPoint& point : path) {
    for (const float* vector : {point.data, point.data_n, point.data_axis})
      for (int i = 0; i < 3; ++i)
        at = put(at, vector[i]);
    at = put(at, point.arc_length);
    at = put(at, point.turn);
    at = put(at, point.over_gap);
  }
  out.write(rows);
  out.close();
}

} // namespace pcl_spiral
