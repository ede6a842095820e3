// SPDX-License-Identifier: BSD-3-Clause
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

/** Text in columns, which may be named. */
bool
hasColumns(const std::string& extension)
{
  return extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".asc";
}

PointTable
readTable(const std::string& file, const std::string& bytes, const std::string& extension, const TextLayout& layout)
{
  constexpr NormalColumns normals = NormalColumns::Read;
  const Names xyz{"x", "y", "z"};
  if (extension == ".stl")
    return readStlTable(file, bytes);
  if (extension == ".las")
    return readLasTable(file, bytes, *layout.warnings);
  refuseWideText(file, bytes);
  if (extension == ".pcd")
    return readPcdTable(file, bytes, xyz, normals);
  if (extension == ".ply")
    return readPlyTable(file, bytes, xyz, normals);
  if (extension == ".obj")
    return readObjTable(file, bytes);
  if (extension == ".pts")
    return readPtsTable(file, bytes, layout);
  return readTextTable(file, bytes, xyz, layout, normals);
}

/** \throw FileError if the name has the extension of a format that is not read */
void
requireKnownName(const std::string& file)
{
  const std::string extension = lowerExtension(file);
  if (extension == ".laz" || extension == ".e57")
    throw FileError(file, Diagnostic(extension, " is not read; ", conversionRemedy(file)));
  const auto& known = cloudExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end() && !isNameless(file))
    throw FileError(
        file, Diagnostic("extension '", extension, "' is not known for a scan; use .pcd .ply .xyz .txt .csv .asc .pts .las .stl or .obj"));
}

/** Refuses what is said of a text if the file is none. */
void
requireText(const std::string& file, const std::string& extension, const ReadOptions& options)
{
  if (!options.columns.empty() && !hasColumns(extension))
    throw FileError(file, "only the columns of text files can be named; leave {ReadOptions::columns} out");
  if (options.skip_lines > 0 && !hasColumns(extension) && extension != ".pts")
    throw FileError(file, "only lines of text files can be skipped; leave {ReadOptions::skip_lines} out");
}

} // namespace

const std::vector<std::string>&
cloudExtensions()
{
  static const std::vector<std::string> extensions{".pcd", ".ply", ".xyz", ".txt", ".csv", ".asc", ".pts", ".las", ".stl", ".obj"};
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
    requireText(file, lowerExtension(file), options);
  const std::string bytes = readStream(file);
  const std::string extension = formatOf(file, bytes, cloudExtensions());
  requireText(file, extension, options);

  Scan scan;
  const PointTable table = readTable(file, bytes, extension, {options.columns, options.skip_lines, &scan.warnings});
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
