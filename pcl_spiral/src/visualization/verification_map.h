// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shared parts of the maps of a verification. Private to visualization.
 */
#pragma once

#include "depth_map.h"
#include "value_style.h"
#include "worst_cells.h"

#include <pcl_spiral/visualization/verification_pictures.h>

namespace pcl_spiral {

/** A place that a map also shows enlarged. */
struct WorstPlace {
  Eigen::Vector3d position, normal;
  double across = 0.0; ///< of the enlarged view, mm
  std::string caption;
};

/** The moves of the path, each half coloured by the value of its end, on \p canvas if nothing hides them.
 */
void addPathMap(Canvas& canvas, const DepthMap& depth, const DisplaySurface& surface, const pcl::PointCloud<ToolpathPoint>& path,
                const std::vector<float>& values, const ValueStyle& style);

/** The same enlarged. */
void addPathInset(Canvas& canvas, int slot, const DisplaySurface& surface, const WorstPlace& worst,
                  const pcl::PointCloud<ToolpathPoint>& path, const std::vector<float>& values, const ValueStyle& style);

/** Points, each in a disc of \p radius pixels, on \p canvas if nothing hides them; none for NaN. */
void addPointMap(Canvas& canvas, const DepthMap& depth, const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<float>& values,
                 double radius, const ValueStyle& style);

/** The same enlarged, discs of \p radius mm, with the path as thin lines. */
void addPointInset(Canvas& canvas, int slot, const DisplaySurface& surface, const WorstPlace& worst,
                   const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<float>& values, double radius, const ValueStyle& style,
                   const pcl::PointCloud<ToolpathPoint>& path);

/** Radius of one disc per point, mm, without gaps, for \p points spread like those of the drawn surface. */
double discRadius(const DisplaySurface& surface, std::size_t points);

constexpr double inset_pitches = 12.0; ///< turns across an enlarged view

/** Width of an enlarged view, mm. */
double insetWidth(const DisplaySurface& surface, const pcl::PointCloud<ToolpathPoint>& path);

/** Point \p index of the path, or the nearest existing index. */
const ToolpathPoint& pathPoint(const pcl::PointCloud<ToolpathPoint>& path, std::size_t index);

} // namespace pcl_spiral
