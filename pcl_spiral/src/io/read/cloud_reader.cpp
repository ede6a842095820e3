// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_formats.h"
#include "common/shell_word.h"
#include "found_degrees.h"
#include "found_format.h"
#include "io/byte_file.h"
#include "point_table.h"
#include "scaled_points.h"
#include "text_encoding.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>

#include <Eigen/Core>

#include <algorithm>
#include <filesystem>

namespace pcl_spiral {
namespace {

/** The format of \p extension; null for a name that says nothing. */
const CloudFormat*
formatNamed(const std::string& extension)
{
  const auto* const found = std::find_if(cloud_formats.begin(), cloud_formats.end(),
                                         [&extension](const CloudFormat& format) { return format.extension == extension; });
  return found == cloud_formats.end() ? nullptr : found;
}

/** \throw FileError if the name has the extension of a format that is not read */
void
requireKnownName(const std::string& file)
{
  const std::string extension = lowerExtension(file);
  if (extension == ".laz" || extension == ".e57")
    throw FileError(file, Diagnostic(extension, " is not read; ", conversionRemedy(file)));
  if (formatNamed(extension) || isNameless(file))
    return;
  std::string known;
  for (const std::string& one : cloudExtensions())
    known += (known.empty() ? "" : &one == &cloudExtensions().back() ? " or " : " ") + one;
  throw FileError(file, Diagnostic("extension '", extension, "' is not known for a scan; use ", known));
}

/** Refuses what is said of a text if the file is none. */
void
requireText(const std::string& file, const CloudFormat& format, const ReadOptions& options)
{
  if (!options.columns.empty() && format.use != TextUse::Columns)
    throw FileError(file, "only the columns of text files can be named; leave {ReadOptions::columns} out");
  if (options.skip_lines > 0 && format.use != TextUse::Columns && format.use != TextUse::Lines)
    throw FileError(file, "only lines of text files can be skipped; leave {ReadOptions::skip_lines} out");
}

} // namespace

const std::vector<std::string>&
cloudExtensions()
{
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> list;
    list.reserve(cloud_formats.size());
    for (const CloudFormat& format : cloud_formats)
      list.emplace_back(format.extension);
    return list;
  }();
  return extensions;
}

std::string
conversionRemedy(const std::string& file)
{
  const std::string named = isNameless(file) ? "scan.laz" : file;
  const std::string converted = std::filesystem::path(named).replace_extension(".ply").string();
  const std::string binary = std::string(2, '-') + "writers.ply.storage_mode=\"little endian\""; // an option of PDAL: text would be rounded
  return (isNameless(file) ? "write it into a file and " : "") +
         ("convert it with PDAL (pdal.io; Debian 12 has no package of it): pdal translate " + shellFile(named)) + " " +
         shellFile(converted) + " " + binary;
}

Scan
readCloud(const std::string& file, const ReadOptions& options)
{
  requireKnownName(file);
  if (!isNameless(file))
    requireText(file, *formatNamed(lowerExtension(file)), options);
  const std::string bytes = readStream(file);
  const std::string extension = formatOf(file, bytes, cloudExtensions());
  const CloudFormat& format = *formatNamed(extension);
  requireText(file, format, options);
  if (format.use != TextUse::None)
    refuseWideText(file, bytes);

  Scan scan;
  const PointTable table = format.read(file, bytes, {options.columns, options.skip_lines, &scan.warnings});
  if (extension != ".las" && looksLikeDegrees(table))
    scan.warnings.push_back(Diagnostic(file, ": the coordinates look as if they ", degreesRemedy(file, table, false)));
  ScaledPoints points = scaledPoints(file, table, options);
  scan.cloud = points.cloud;
  scan.shift = points.shift;
  scan.warnings.insert(scan.warnings.end(), points.warnings.begin(), points.warnings.end());
  if (table.size() >= 6)
    scan.normals = unitNormals({table[3], table[4], table[5]});
  if (extension == ".pcd")
    if (const auto place = readPcdViewPoint(file, bytes, table))
      scan.view_point = millimetres(options.unit) * (*place - options.origin) - scan.shift;
  if (scan.view_point)
    scan.cloud->sensor_origin_.head<3>() = scan.view_point->cast<float>();
  return scan;
}

} // namespace pcl_spiral
