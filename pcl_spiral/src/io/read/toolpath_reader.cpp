// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "point_table.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>

namespace pcl_spiral {
namespace {

/** Columns of a path: x y z, normal, axis, arc length, turn, and feed and tip if present. */
ToolpathFile
fromColumns(const PointTable& table)
{
  ToolpathFile file;
  file.path.resize(table[0].size());
  for (std::size_t i = 0; i < file.path.size(); ++i) {
    ToolpathPoint& point = file.path[i];
    for (std::size_t c = 0; c < 3; ++c) {
      point.data[c] = static_cast<float>(table[c][i]);
      point.data_n[c] = static_cast<float>(table[3 + c][i]);
      point.data_axis[c] = static_cast<float>(table[6 + c][i]);
    }
    point.arc_length = table[9][i];
    point.turn = static_cast<float>(table[10][i]);
  }
  if (table.size() > 11)
    file.feed = table[11];
  if (table.size() > 14)
    for (std::size_t i = 0; i < file.path.size(); ++i)
      file.tips.emplace_back(table[12][i], table[13][i], table[14][i]);
  return file;
}

/** Keeps the arc length unchanged on the way to each of \p passes: each polyline is a separate pass. */
void
liftBetween(const std::vector<std::size_t>& passes, pcl::PointCloud<ToolpathPoint>& path)
{
  double lifted = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (next < passes.size() && passes[next] == i) {
      lifted += path[i].arc_length - (path[i - 1].arc_length + lifted);
      ++next;
    }
    path[i].arc_length -= lifted;
  }
}

} // namespace

ToolpathFile
readToolpath(const std::string& file)
{
  const std::string extension = lowerExtension(file);
  const Names tail{"axis_x", "axis_y", "axis_z", "arc_length", "turn"};
  const auto names = [&tail](Names first, const Names& last = {}) {
    first.insert(first.end(), tail.begin(), tail.end());
    first.insert(first.end(), last.begin(), last.end());
    return first;
  };
  if (extension == ".csv")
    return fromColumns(readTextTable(
        file, readBytes(file), names({"cc_x", "cc_y", "cc_z", "normal_x", "normal_y", "normal_z"}, {"feed", "tip_x", "tip_y", "tip_z"})));
  if (extension == ".pcd")
    return fromColumns(readPcdTable(file, readBytes(file), names({"x", "y", "z", "normal_x", "normal_y", "normal_z"})));
  if (extension == ".ply")
    return fromColumns(readPlyTable(file, readBytes(file), names({"x", "y", "z", "nx", "ny", "nz"})));
  if (extension == ".vtp") {
    const auto bytes = readBytes(file);
    ToolpathFile read = fromColumns(readVtpTable(file, bytes));
    liftBetween(readVtpPasses(file, bytes), read.path);
    return read;
  }
  throw FileError(file, "extension '" + extension + "' is not known for a toolpath; use .csv, .pcd, .ply or .vtp");
}

} // namespace pcl_spiral
