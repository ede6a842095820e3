// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Removes false echoes from the points of a scan and keeps what stands on the table.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Most points of a false echo. It usually is a single point; sometimes two or three lie together. A screw or a clamp has more. */
constexpr std::size_t largest_echo = 3;

/** The finite \p points without false echoes, in their order. False echoes are outliers in groups of at most \p largest points, see
 *  OutlierRemoval. Returns all points if they form no surface. */
std::vector<Eigen::Vector3f> withoutEchoes(const std::vector<Eigen::Vector3f>& points, std::size_t largest);

/** The \p points of \p scan that are no false echoes among all of it, in their order; groups of at most largest_echo. */
std::vector<Eigen::Vector3f> withoutEchoes(const std::vector<Eigen::Vector3f>& points, const pcl::PointCloud<pcl::PointXYZ>& scan);

} // namespace pcl_spiral
