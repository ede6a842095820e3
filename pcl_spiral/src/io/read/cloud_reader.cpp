// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "point_table.h"
#include "scaled_points.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

bool
isText(const std::string& extension)
{
  return extension == ".xyz" || extension == ".txt" || extension == ".csv" || extension == ".asc";
}

PointTable
readTable(const std::string& file, const std::string& extension, const Names& columns)
{
  const std::string bytes = readBytes(file);
  const Names xyz{"x", "y", "z"};
  if (extension == ".pcd")
    return readPcdTable(file, bytes, xyz);
  if (extension == ".ply")
    return readPlyTable(file, bytes, xyz);
  if (extension == ".stl")
    return readStlTable(file, bytes);
  if (extension == ".obj")
    return readObjTable(file, bytes);
  return readTextTable(file, bytes, xyz, columns);
}

} // namespace

const std::vector<std::string>&
cloudExtensions()
{
  static const std::vector<std::string> extensions{".pcd", ".ply", ".xyz", ".txt", ".csv", ".asc", ".stl", ".obj"};
  return extensions;
}

Scan
readCloud(const std::string& file, const ReadOptions& options)
{
  const std::string extension = lowerExtension(file);
  const auto& known = cloudExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw FileError(file, "extension '" + extension + "' is not known for a scan; use .pcd .ply .xyz .txt .csv .asc .stl or .obj");
  if (!options.columns.empty() && !isText(extension))
    throw FileError(file, "only the columns of text files can be named; leave ReadOptions::columns out");

  Scan scan;
  scan.cloud = scaledPoints(readTable(file, extension, options.columns), options);
  scan.warnings = scaleWarnings(file, *scan.cloud);
  return scan;
}

} // namespace pcl_spiral
