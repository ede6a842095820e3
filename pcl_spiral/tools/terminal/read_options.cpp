// SPDX-License-Identifier: BSD-3-Clause
#include "read_options.h"

#include "scan_places.h"

using namespace pcl_spiral;

const char* const columns_help = "names of the columns of a text file, from the left; x, y and z are used: --columns id,x,y,z";
const char* const skip_lines_help = "lines at the beginning of a text file that are not read, whatever is in them: --skip-lines 2";
const char* const raw_scan_help =
    "the scan before it was smoothed: says what smoothing moved, and the path must not cut into its points: --raw-scan raw.pcd";

std::string
scanExtensions()
{
  std::string list;
  for (const std::string& extension : cloudExtensions())
    list += (list.empty() ? "" : " ") + extension;
  return list;
}

std::size_t
skipLinesValue(const std::string& value)
{
  const int lines = wholeNumberValue("skip-lines", value);
  requireOption(lines >= 0, "skip-lines", lines, "must be 0 lines or more");
  return static_cast<std::size_t>(lines);
}

std::vector<Option>
readOptions(ReadOptions& read)
{
  return {choiceOption("units", units_help, read.unit),
          originOption(read),
          {"columns", "NAMES", columns_help, [&read](const std::string& value) { read.columns = listValue(value); }},
          {"skip-lines", "N", skip_lines_help, [&read](const std::string& value) { read.skip_lines = skipLinesValue(value); }}};
}
