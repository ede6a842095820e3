// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Heights of ridges along a toolpath.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace pcl_spiral {

/** Height of the ridge next to each point of \p path, mm: that of the nearest point of the surface. \p stock and \p ridges, one per
 *  point, are the output of MaterialRemoval and its getRidgeHeights; the points with a stock are those of the surface. NaN: the nearest
 *  point has no ridge, or no point has a stock. */
std::vector<float> ridgesAlong(const pcl::PointCloud<ToolpathPoint>& path, const pcl::PointCloud<pcl::PointXYZI>& stock,
                               const std::vector<float>& ridges);

} // namespace pcl_spiral
