// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Toolpath points as packed binary records, the same in .pcd and .ply.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** For every point: float x y z, normal, axis, double arc_length, float turn, uchar over_gap, float lift, little-endian. With an
 *  \p origin x y z are double, and it is added to them. */
std::string toolpathRows(const pcl::PointCloud<ToolpathPoint>& path, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

} // namespace pcl_spiral
