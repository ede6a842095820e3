// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath_rows.h"

#include <cstring>

namespace pcl_spiral {
namespace {

constexpr std::size_t bytes_behind_place = 6 * sizeof(float) + sizeof(double) + sizeof(float) + 1 + sizeof(float);

template <typename T>
char*
put(char* out, T value)
{
  std::memcpy(out, &value, sizeof(T));
  return out + sizeof(T);
}

} // namespace

std::string
toolpathRows(const pcl::PointCloud<ToolpathPoint>& path, const Eigen::Vector3d& origin)
{
  const bool moved = !origin.isZero();
  std::string rows(path.size() * (bytes_behind_place + 3 * (moved ? sizeof(double) : sizeof(float))), '\0');
  char* at = rows.data();
  for (const ToolpathPoint& point : path) {
    for (int i = 0; i < 3; ++i)
      at = moved ? put(at, point.data[i] + origin[i]) : put(at, point.data[i]);
    for (const float* vector : {point.data_n, point.data_axis})
      for (int i = 0; i < 3; ++i)
        at = put(at, vector[i]);
    at = put(at, point.arc_length);
    at = put(at, point.turn);
    at = put(at, point.over_gap);
    at = put(at, point.lift);
  }
  return rows;
}

} // namespace pcl_spiral
