// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writers of toolpath files.
 */
#pragma once

#include <pcl_spiral/common/tool_tip.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl_spiral {

/** Contents of a toolpath file apart from the path. */
struct ToolpathMotion {
  double tool_radius = 0.0;               ///< ball radius, mm; needed for the tip
  double feed = 0.0;                      ///< at the contact, mm/min
  std::vector<Eigen::Vector3d> tips = {}; ///< one per point, of a cutter that is not a ball; empty: those of the ball
  std::vector<std::size_t> passes = {};   ///< where the second pass and each further one begin; empty: as passBegins finds them
  /** Added to contacts and tips, mm, in double precision: Scan::shift, if the path was made in shifted coordinates. A .pcd keeps its
   *  float coordinates and names this place in a comment, which readToolpath uses. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

/** More values of a path, one per point; empty: none. */
struct PathValues {
  std::vector<double> feed;     ///< mm/min, used instead of that of the motion
  std::vector<float> deviation; ///< mm, positive out of the material; NaN: not measured
  std::vector<float> scallop;   ///< height of the ridge next to the point, mm; NaN: not measured
};

/** First line of a toolpath CSV. */
extern const char* const toolpath_csv_header;

/** Writes comma separated values under toolpath_csv_header: mm, mm/min, unit
 *  vectors; positions, lengths and turns with 6 decimals, vectors with 9, the
 *  feed with 3; over_gap is 1 over a bridged gap of the scan, else 0; lift in mm with 6. There are no comment lines.
 *  The same bytes for any number of threads. \throw FileError */
void writeToolpathCSV(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion);

/** Writes a binary PCD of ToolpathPoint; \p origin as in ToolpathMotion. \throw FileError */
void writeToolpathPCD(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path,
                      const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

/** Writes a binary little-endian PLY: float x y z nx ny nz axis_x axis_y axis_z, double arc_length, float
 *  turn, uchar over_gap, float lift. The normal has the names that mesh viewers know; PCL reads them back as normal_x.. With an
 *  \p origin, as in ToolpathMotion, x y z are double. \throw FileError */
void writeToolpathPLY(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path,
                      const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

/** Writes one polyline per pass, with point data Normals, ToolAxis, Feed (if known), Turn, ArcLength, OverGap and Lift (if any is not
 *  0), Tip (if tips are given), and Deviation and Scallop from \p values, if given. \throw FileError, std::invalid_argument for values
 *  that are not one per point */
void writeToolpathVTP(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion,
                      const PathValues& values = {});

/** Extensions that writeToolpath accepts, with the dot. */
const std::vector<std::string>& toolpathExtensions();

/** Writes by the extension of \p file. \p values are written where the format has room
 *  for them, in .vtp. \throw FileError unknown extension, or the file cannot be written */
void writeToolpath(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion,
                   const PathValues& values = {});

} // namespace pcl_spiral
