// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "io/pcd_origin.h"
#include "point_table.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t longest_head = 64; ///< lines
const char* const gap_column = "over_gap";

/** True if a line of the head of a .csv, .pcd or .ply names the column; files of earlier versions and of other programs have none. */
bool
hasGapColumn(std::string_view bytes)
{
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  while (lines.number() < longest_head && lines.next(line)) {
    if (line.find(gap_column) == std::string_view::npos || line[0] == '#' || line.substr(0, 7) == "comment")
      continue;
    splitWords(line, line.find(',') != std::string_view::npos ? ',' : ' ', words);
    if (std::find(words.begin(), words.end(), gap_column) != words.end())
      return true;
  }
  return false;
}

/** The place that the coordinates of a .pcd are relative to, from its comment; zero if it has none. */
Eigen::Vector3d
originOf(const std::string& file, std::string_view bytes)
{
  LineScanner lines(bytes);
  std::string_view line;
  const std::string_view mark = trimmed(pcd_origin_mark);
  while (lines.number() < longest_head && lines.next(line) && line.substr(0, 4) != "DATA") {
    if (line.substr(0, mark.size()) != mark)
      continue;
    std::vector<std::string_view> words;
    splitWords(line.substr(mark.size()), ' ', words);
    Eigen::Vector3d origin;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::optional<double> value = words.size() == 3 ? toNumber(words[c]) : std::nullopt;
      if (!value)
        throw FileError(file, atLine(lines.number(), "the comment of the origin needs three numbers"));
      origin[static_cast<Eigen::Index>(c)] = *value;
    }
    return origin;
  }
  return Eigen::Vector3d::Zero();
}

/** Columns of a path: x y z, normal, axis, arc length, turn, and feed and tip if present; the last is over_gap if it is \p marked.
 *  \p origin is subtracted. */
ToolpathFile
fromColumns(const PointTable& table, const Eigen::Vector3d& origin, bool marked = false)
{
  const std::size_t columns = table.size() - (marked ? 1 : 0);
  ToolpathFile file;
  file.path.resize(table[0].size());
  for (std::size_t i = 0; i < file.path.size(); ++i) {
    ToolpathPoint& point = file.path[i];
    for (std::size_t c = 0; c < 3; ++c) {
      point.data[c] = static_cast<float>(table[c][i] - origin[static_cast<Eigen::Index>(c)]);
      point.data_n[c] = static_cast<float>(table[3 + c][i]);
      point.data_axis[c] = static_cast<float>(table[6 + c][i]);
    }
    point.arc_length = table[9][i];
    point.turn = static_cast<float>(table[10][i]);
    point.over_gap = marked && table[columns][i] != 0.0;
  }
  if (columns > 11)
    file.feed = table[11];
  if (columns > 14)
    for (std::size_t i = 0; i < file.path.size(); ++i)
      file.tips.push_back(Eigen::Vector3d(table[12][i], table[13][i], table[14][i]) - origin);
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
readToolpath(const std::string& file, const Eigen::Vector3d& origin)
{
  const std::string extension = lowerExtension(file);
  const Names tail{"axis_x", "axis_y", "axis_z", "arc_length", "turn"};
  const auto readColumns = [&](const auto& table_of, Names wanted, const Names& last = {}) {
    const auto bytes = readBytes(file);
    const bool marked = hasGapColumn(bytes);
    wanted.insert(wanted.end(), tail.begin(), tail.end());
    wanted.insert(wanted.end(), last.begin(), last.end());
    if (marked)
      wanted.emplace_back(gap_column);
    const Eigen::Vector3d added = extension == ".pcd" ? originOf(file, bytes) : Eigen::Vector3d::Zero();
    return fromColumns(table_of(file, bytes, wanted), origin - added, marked);
  };
  const auto readText = [](const auto&... of) { return readTextTable(of...); };
  const auto readPcd = [](const auto&... of) { return readPcdTable(of...); };
  const auto readPly = [](const auto&... of) { return readPlyTable(of...); };
  if (extension == ".csv")
    return readColumns(readText, {"cc_x", "cc_y", "cc_z", "normal_x", "normal_y", "normal_z"}, {"feed", "tip_x", "tip_y", "tip_z"});
  if (extension == ".pcd")
    return readColumns(readPcd, {"x", "y", "z", "normal_x", "normal_y", "normal_z"});
  if (extension == ".ply")
    return readColumns(readPly, {"x", "y", "z", "nx", "ny", "nz"});
  if (extension == ".vtp") {
    const auto bytes = readBytes(file);
    ToolpathFile read = fromColumns(readVtpTable(file, bytes), origin);
    liftBetween(readVtpPasses(file, bytes), read.path);
    return read;
  }
  throw FileError(file, "extension '" + extension + "' is not known for a toolpath; use .csv, .pcd, .ply or .vtp");
}

} // namespace pcl_spiral
