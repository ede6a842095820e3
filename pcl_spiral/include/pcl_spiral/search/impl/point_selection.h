// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Selects which points of a cloud to keep. Each function returns ascending indices of its input.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One point per place: the first of those with the same coordinates. \p points finite. */
std::vector<std::uint32_t> distinctPoints(const std::vector<Eigen::Vector3f>& points);

/** The points whose mean distance to their \p neighbours nearest points is at most mean + \p deviations standard
 * deviations of this distance over all points: pcl::StatisticalOutlierRemoval, in parallel. \p points finite; \p
 * neighbours 1 or more. */
std::vector<std::uint32_t> statisticalInliers(const std::vector<Eigen::Vector3f>& points, int neighbours, double deviations);

/** One point per voxel of edge length \p edge: the one nearest to the centroid of the voxel. The grid starts at
 * the origin. Unlike the grids of PCL it has 2^21 voxels along each axis; empty if the points need more.
 *  \p points finite; \p edge above 0. */
std::vector<std::uint32_t> voxelRepresentatives(const std::vector<Eigen::Vector3f>& points, double edge);

} // namespace pcl_spiral
