// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far the nearest neighbours of every point are. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Mean distance of each of \p points to its \p neighbours nearest (to all others, if they are fewer). Exact; as fast where
 *  many points lie off the surface. */
std::vector<float> meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours);

} // namespace pcl_spiral
