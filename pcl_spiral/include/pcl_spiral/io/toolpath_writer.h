/** \file
 *  Writers of toolpath files.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl_spiral {

/** What a toolpath file says beyond the path. */
struct ToolpathMotion {
  double tool_radius = 0.0; ///< ball radius, mm; places the tip
  double feed = 0.0;        ///< at the contact, mm/min
  std::vector<Eigen::Vector3d> tips = {}; ///< of a cutter that is no ball, one a point; empty: of the ball
  std::vector<std::size_t> passes = {};   ///< where the second pass begins, and each further one; empty: as passBegins finds them
};

/** More values of a path, one a point; empty: none. */
struct PathValues {
  std::vector<double> feed;     ///< mm/min, in place of the motion's
  std::vector<float> deviation; ///< mm, positive out of the material; NaN: not measured
  std::vector<float> scallop;   ///< height of the ridge beside the point, mm; NaN: none was measured
};

/** Tip of a ball cutter that touches at \p point: contact + radius (normal - axis), mm. */
inline Eigen::Vector3d
toolTip(const ToolpathPoint& point, double tool_radius)
{
  const Eigen::Vector3d normal = point.getNormalVector3fMap().cast<double>();
  const Eigen::Vector3d axis = point.getAxisVector3fMap().cast<double>();
  return point.getVector3fMap().cast<double>() + tool_radius * (normal - axis);
}

/** First line of a toolpath CSV. */
extern const char* const toolpath_csv_header;

/** Comma separated values under toolpath_csv_header: mm, mm/min, unit vectors; positions, lengths and turns
 * with 6 decimals, vectors with 9, the feed with 3. The same bytes for any number of threads. \throw
 * FileError */
void writeToolpathCSV(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path,
                      const ToolpathMotion& motion);

/** Binary PCD of ToolpathPoint. \throw FileError */
void writeToolpathPCD(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path);

/** Binary little-endian PLY: float x y z nx ny nz axis_x axis_y axis_z, double arc_length, float turn. The
 * normal has the names that mesh viewers know; PCL reads them back as normal_x.. \throw FileError */
void writeToolpathPLY(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path);

/** One polyline a pass, with point data Normals, ToolAxis, Feed (where one is known), Turn, ArcLength, Tip (where tips are given), and of \p values what is
 * given as Deviation and Scallop. \throw FileError, std::invalid_argument for values that are not one a point */
void writeToolpathVTP(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path,
                      const ToolpathMotion& motion, const PathValues& values = {});

/** Extensions that writeToolpath knows, with the dot. */
const std::vector<std::string>& toolpathExtensions();

/** By the extension of \p file; \p values go where the format has room for them, into .vtp. \throw FileError extension
 * not known, or the file cannot be written */
void writeToolpath(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path,
                   const ToolpathMotion& motion, const PathValues& values = {});

} // namespace pcl_spiral
