// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Mean distance of every point to its nearest neighbours. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Mean distance of each of \p points to its \p neighbours nearest (to all others, if they are fewer). Exact, and as fast if
 *  many points lie off the surface. */
std::vector<float> meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours);

} // namespace pcl_spiral
