// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/io/polygon_reader.h>

#include "../byte_file.h"
#include "text_encoding.h"
#include "text_scan.h"

#include "core/polygon_prism.h"

#include <pcl_spiral/io/file_error.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace pcl_spiral {
namespace {

/** The numbers of a line; empty for a heading. */
std::vector<double>
numbersOf(const std::string& file, std::string_view line, std::size_t at)
{
  std::vector<std::string_view> words;
  splitWords(line, separatorOf(line), words);
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const auto number = toNumber(unquoted(word));
    if (!number && numbers.empty() && sameWord(unquoted(word), "x"))
      return {};
    if (!number || !std::isfinite(*number))
      throw FileError(file, atLine(at, Diagnostic(inQuotes(word), " is not a number; write one corner per line as x y or x y z")));
    numbers.push_back(*number);
  }
  if (numbers.size() < 2 || numbers.size() > 3)
    throw FileError(file, atLine(at, Diagnostic(numbers.size(), " numbers; write one corner per line as x y or x y z")));
  return numbers;
}

} // namespace

Prism
readPolygon(const std::string& file, const ReadOptions& options)
{
  const auto bytes = readBytes(file);
  refuseWideText(file, bytes);
  std::vector<Eigen::Vector3d> corners;
  std::size_t columns = 0;
  LineScanner lines({bytes.data(), bytes.size()});
  for (std::string_view line; lines.next(line);) {
    if (line.empty() || line.front() == '#' || line.substr(0, 2) == "//")
      continue;
    const std::vector<double> numbers = numbersOf(file, line, lines.number());
    if (numbers.empty())
      continue;
    if (columns != 0 && columns != numbers.size())
      throw FileError(file, atLine(lines.number(), "some corners have a z and some have none; give it for all corners or for none"));
    columns = numbers.size();
    const Eigen::Vector3d corner(numbers[0], numbers[1], columns > 2 ? numbers[2] : options.origin.z());
    corners.push_back(millimetres(options.unit) * (corner - options.origin));
  }
  Prism prism = prismOver(corners, columns > 2);
  if (!prism.fault().empty())
    throw FileError(file, Diagnostic("the polygon is no area: ", prism.fault()));
  return prism;
}

} // namespace pcl_spiral
