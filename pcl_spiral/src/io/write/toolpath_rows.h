// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Toolpath points as packed binary records, the same in .pcd and .ply.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** For every point: float x y z, normal, axis, double arc_length, float turn, uchar over_gap, little-endian. */
std::string toolpathRows(const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral
