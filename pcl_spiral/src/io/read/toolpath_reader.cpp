// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "io/pcd_origin.h"
#include "point_table.h"
#include "read_tips.h"
#include "text_encoding.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t longest_head = 64;                            ///< lines
const std::array<const char*, 2> later_columns{"over_gap", "lift"}; // files of earlier versions and of other programs have none

/** Those of later_columns that a line of the head of a .csv, .pcd or .ply names. */
Names
laterColumns(std::string_view bytes)
{
  LineScanner lines(bytes);
  std::string_view line;
  std::vector<std::string_view> words;
  Names found;
  while (lines.number() < longest_head && lines.next(line)) {
    if (line.empty() || line[0] == '#' || line.substr(0, 7) == "comment")
      continue;
    splitWords(line, line.find(',') != std::string_view::npos ? ',' : ' ', words);
    for (const char* const name : later_columns)
      if (std::find(words.begin(), words.end(), name) != words.end() && std::find(found.begin(), found.end(), name) == found.end())
        found.emplace_back(name);
  }
  return found;
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

/** Columns of a path: x y z, normal, axis, arc length, turn, and feed and tip if present; the last are \p later.
 *  \p origin is subtracted. */
ToolpathFile
fromColumns(const PointTable& table, const Eigen::Vector3d& origin, const Names& later = {})
{
  const std::size_t columns = table.size() - later.size();
  const auto column = [&](const char* name) {
    const auto at = std::find(later.begin(), later.end(), name);
    return at == later.end() ? nullptr : &table[columns + static_cast<std::size_t>(at - later.begin())];
  };
  const auto* const gaps = column(later_columns[0]);
  const auto* const lifts = column(later_columns[1]);
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
    point.over_gap = gaps && (*gaps)[i] != 0.0;
    point.lift = lifts ? static_cast<float>((*lifts)[i]) : 0.0f;
  }
  if (columns > 11)
    file.feed = table[11];
  if (columns > 14)
    for (std::size_t i = 0; i < file.path.size(); ++i)
      file.tips.push_back(Eigen::Vector3d(table[12][i], table[13][i], table[14][i]) - origin);
  return file;
}

/** Refuses rows in another order than that of the path. Passes that were put together may begin at 0 again, each once. */
void
requireOrder(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path)
{
  constexpr std::size_t rows_per_pass = 10; // at least
  std::size_t falls = 0, first = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].arc_length < path[i - 1].arc_length && falls++ == 0)
      first = i;
  if (falls * rows_per_pass > path.size())
    throw FileError(file, Diagnostic("the points are not in the order of the path: the arc length falls at ", falls, " of ", path.size(),
                                     " points, first at point ", first + 1, "; sort the rows by arc_length"));
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
    refuseWideText(file, bytes);
    const Names later = laterColumns(bytes);
    wanted.insert(wanted.end(), tail.begin(), tail.end());
    wanted.insert(wanted.end(), last.begin(), last.end());
    wanted.insert(wanted.end(), later.begin(), later.end());
    const Eigen::Vector3d added = extension == ".pcd" ? originOf(file, bytes) : Eigen::Vector3d::Zero();
    ToolpathFile read = fromColumns(table_of(file, bytes, wanted), origin - added, later);
    requireOrder(file, read.path);
    return read;
  };
  const auto readText = [](const auto&... of) { return readTextTable(of...); };
  const auto readPcd = [](const auto&... of) { return readPcdTable(of...); };
  const auto readPly = [](const auto&... of) { return readPlyTable(of...); };
  if (extension == ".csv" && holdsOnlyTips(readBytes(file)))
    return readTips(file, origin);
  if (extension == ".csv")
    return readColumns(readText, {"cc_x", "cc_y", "cc_z", "normal_x", "normal_y", "normal_z"}, {"feed", "tip_x", "tip_y", "tip_z"});
  if (extension == ".pcd")
    return readColumns(readPcd, {"x", "y", "z", "normal_x", "normal_y", "normal_z"});
  if (extension == ".ply")
    return readColumns(readPly, {"x", "y", "z", "nx", "ny", "nz"});
  if (extension == ".vtp") {
    const auto bytes = readBytes(file);
    Names later;
    const PointTable table = readVtpTable(file, bytes, later);
    ToolpathFile read = fromColumns(table, origin, later);
    liftBetween(readVtpPasses(file, bytes), read.path);
    if (const PointTable tips = readVtpTips(file, bytes); !tips.empty())
      for (std::size_t i = 0; i < read.path.size(); ++i)
        read.tips.push_back(Eigen::Vector3d(tips[0][i], tips[1][i], tips[2][i]) - origin);
    return read;
  }
  throw FileError(file, Diagnostic("extension '", extension, "' is not known for a toolpath; use .csv, .pcd, .ply or .vtp"));
}

} // namespace pcl_spiral
