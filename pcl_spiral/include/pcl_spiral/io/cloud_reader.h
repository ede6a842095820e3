// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of scans.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

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
  Inch,       ///< 25.4 mm
  Foot,       ///< international foot, 304.8 mm
  SurveyFoot  ///< US survey foot, 1200/3937 m
};

/** Millimetres in one \p unit. */
constexpr double
millimetres(LengthUnit unit)
{
  switch (unit) {
  case LengthUnit::Metre:
    return 1000.0;
  case LengthUnit::Inch:
    return 25.4;
  case LengthUnit::Foot:
    return 304.8;
  case LengthUnit::SurveyFoot:
    return 1200000.0 / 3937.0;
  default:
    return 1.0;
  }
}

/** How to read the numbers in a scan. */
struct ReadOptions {
  LengthUnit unit = LengthUnit::Millimetre;         ///< of the numbers in the file
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); ///< subtracted in double precision, in the unit of the file
  /** Text files only: a name for each column, from the left; the columns named x, y and z are
   *  used. Empty: taken from the header of the file, otherwise the first three columns. */
  std::vector<std::string> columns;
  std::size_t skip_lines = 0; ///< text files only: lines at the beginning that are not read, such as a title
  /** Subtract a round place near the points, too, if single precision would round their coordinates by more than 0.001 mm and
   *  they are far from 0 for their extent, as map coordinates are; see Scan::shift. */
  bool find_origin = false;
};

/** A scan in mm. */
struct Scan {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;       ///< never null
  pcl::PointCloud<pcl::Normal>::Ptr normals;       ///< normals in the file, one per point, zero for none; null: the file has none
  std::optional<Eigen::Vector3d> view_point;       ///< VIEWPOINT of a .pcd, mm; the default 0 0 0 only of a camera's image
  Diagnostics warnings;                            ///< what the reader found and did not change
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< mm, whole: subtracted by ReadOptions::find_origin; zero: nothing
};

/** Extensions that readCloud accepts, with the dot. */
const std::vector<std::string>& cloudExtensions();

/** Reads the points of a .pcd, .ply, .stl, .obj (vertices), .las, or of a text file .xyz .txt .csv .asc .pts.
 *
 *  Text: one point per line; columns separated by commas, semicolons, or blanks; comment
 *  lines start with # or //. Numbers may be in quotes. Titles and the number of points may stand above them: a warning names titles
 *  that were passed over. A .pts begins with the number of its points. LAS: versions 1.0 to 1.4, not compressed, without the points that
 *  are flagged withheld, which a warning counts; degrees are refused. The format of a pipe without a known extension, as of /dev/stdin,
 *  is found from its content. Scaling and shift are done in double precision, then rounded to float; a warning reports where the
 *  rounding is more than 0.001 mm. Nothing else is changed: not-a-number points and duplicates stay. Columns nx ny nz, or normal_x
 *  normal_y normal_z, of a .pcd, .ply or text file are read as normals. \throw FileError with the line or byte and the reason: missing,
 *  a folder, empty, cut off, not a number, no x y z, degrees, text in UTF-16, unknown extension; for .laz and .e57 with a command that
 *  converts them */
Scan readCloud(const std::string& file, const ReadOptions& options = {});

} // namespace pcl_spiral
