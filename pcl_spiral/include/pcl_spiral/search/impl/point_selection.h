/** \file
 *  Which points of a cloud to keep. Each function returns ascending indices of its input.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One point of each place: the first of those with the same coordinates. \p points finite. */
std::vector<std::uint32_t> distinctPoints(const std::vector<Eigen::Vector3f>& points);

/** The points whose mean distance to their \p neighbours nearest is at most mean + \p deviations standard
 * deviations of that over all points: pcl::StatisticalOutlierRemoval, in parallel. \p points finite; \p
 * neighbours 1 or more. */
std::vector<std::uint32_t> statisticalInliers(const std::vector<Eigen::Vector3f>& points, int neighbours,
                                              double deviations);

/** One point of each voxel of edge \p edge: the one nearest to the voxel's centroid. The grid stands at the
 * origin. Unlike those of PCL it has room for 2^21 voxels along each axis; empty when the points need more.
 *  \p points finite; \p edge above 0. */
std::vector<std::uint32_t> voxelRepresentatives(const std::vector<Eigen::Vector3f>& points, double edge);

} // namespace pcl_spiral
