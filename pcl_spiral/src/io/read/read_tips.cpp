// SPDX-License-Identifier: BSD-3-Clause
#include "read_tips.h"

#include "io/byte_file.h"
#include "point_table.h"
#include "text_scan.h"
#include <pcl_spiral/io/file_error.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

/** The words of the first line that is not a comment. */
Names
firstWords(std::string_view bytes)
{
  LineScanner lines(bytes);
  std::string_view line;
  while (lines.next(line))
    if (!line.empty() && line[0] != '#')
      break;
  std::vector<std::string_view> words;
  splitWords(line, line.find(',') != std::string_view::npos ? ',' : line.find(';') != std::string_view::npos ? ';' : ' ', words);
  return {words.begin(), words.end()};
}

bool
names(const Names& words, std::string_view name)
{
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return sameWord(word, name); });
}

} // namespace

bool
holdsOnlyTips(std::string_view bytes)
{
  const Names words = firstWords(bytes);
  const bool numbers = std::all_of(words.begin(), words.end(), [](const std::string& word) { return toNumber(word).has_value(); });
  return (numbers && words.size() == 6) || (!names(words, "cc_x") && (names(words, "tip_x") || (names(words, "x") && names(words, "i"))));
}

ToolpathFile
readTips(const std::string& file, const Eigen::Vector3d& origin)
{
  const auto bytes = readBytes(file);
  const Names words = firstWords(bytes);
  Names wanted =
      names(words, "tip_x") ? Names{"tip_x", "tip_y", "tip_z", "axis_x", "axis_y", "axis_z"} : Names{"x", "y", "z", "i", "j", "k"};
  for (const char* more : {"feed", "pass"})
    if (names(words, more))
      wanted.emplace_back(more);
  const PointTable table = readTextTable(file, bytes, wanted);
  const std::size_t size = table[0].size();
  ToolpathFile read;
  read.has_contacts = false;
  read.path.resize(size);
  if (names(words, "feed"))
    read.feed = table[6];
  double length = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3d axis(table[3][i], table[4][i], table[5][i]);
    if (!(axis.norm() > 1e-6))
      throw FileError(file, Diagnostic("point ", i + 1, " has no tool axis: its three components are 0"));
    read.tips.push_back(Eigen::Vector3d(table[0][i], table[1][i], table[2][i]) - origin);
    ToolpathPoint& point = read.path[i];
    point.getVector3fMap() = read.tips[i].cast<float>();
    point.getAxisVector3fMap() = axis.normalized().cast<float>();
    const bool lifted = i > 0 && names(words, "pass") && table.back()[i] != table.back()[i - 1];
    if (i > 0 && !lifted)
      length += (read.tips[i] - read.tips[i - 1]).norm();
    point.arc_length = length;
    point.turn = names(words, "pass") ? static_cast<float>(table.back()[i]) : 0.0f;
  }
  return read;
}

} // namespace pcl_spiral
