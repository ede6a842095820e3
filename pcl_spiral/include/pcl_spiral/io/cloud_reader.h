// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of scans.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Unit of the coordinates in a file; the library uses millimetres. */
enum class LengthUnit {
  Millimetre, ///< the default
  Metre,      ///< 1000 mm
  Inch        ///< 25.4 mm
};

/** Millimetres in one \p unit. */
constexpr double
millimetres(LengthUnit unit)
{
  return unit == LengthUnit::Metre ? 1000.0 : unit == LengthUnit::Inch ? 25.4 : 1.0;
}

/** How to read the numbers in a scan. */
struct ReadOptions {
  LengthUnit unit = LengthUnit::Millimetre;         ///< of the numbers in the file
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< subtracted in double precision, in the unit of the file
  /** Text files only: a name for each column, from the left; the columns named x, y and z are
   *  used. Empty: taken from the header of the file, otherwise the first three columns. */
  std::vector<std::string> columns;
};

/** A scan in mm. */
struct Scan {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud; ///< never null
  pcl::PointCloud<pcl::Normal>::Ptr normals; ///< normals in the file, one per point, zero for none; null: the file has none
  std::optional<Eigen::Vector3d> view_point; ///< VIEWPOINT of a .pcd, mm, unless it is the default 0 0 0 1 0 0 0
  std::vector<std::string> warnings;         ///< what the reader found and did not change
};

/** Extensions that readCloud accepts, with the dot. */
const std::vector<std::string>& cloudExtensions();

/** Reads the points of a .pcd, .ply, .stl, .obj (vertices), or of a text file .xyz .txt .csv .asc.
 *
 *  Text: one point per line; columns separated by commas, semicolons, or blanks; comment
 *  lines start with # or //. Scaling and shift are done in double precision, then rounded to
 *  float; a warning reports where the rounding is more than 0.001 mm. Nothing else is changed:
 *  not-a-number points and duplicates stay. Columns nx ny nz, or normal_x normal_y normal_z, of a .pcd, .ply or text file are
 *  read as normals. \throw FileError with the line or byte and the
 *  reason: missing, a folder, empty, cut off, not a number, no x y z, unknown extension */
Scan readCloud(const std::string& file, const ReadOptions& options = {});

} // namespace pcl_spiral
