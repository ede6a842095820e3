// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far the tool may lean beside obstacles. Private to spiral.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_path.h>

#include <vector>

namespace pcl_spiral {

/** The unit axis that leans from \p normal only by a \p share, 0 to 1, of what \p axis leans. */
Eigen::Vector3d leaned(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis, double share);

/** The share, 0 to 1, of the lean of each of \p axes with which a shank of \p radius, mm, shank_radii long, is clear of the points
 *  \p obstacles, also on the moves to the points before and after, and with each smaller share. 0 where not even an upright shank is
 *  clear. Along a pass of \p path it changes by no more than \p rate per mm. */
std::vector<double> leanShares(const SpiralPath& path, const std::vector<Eigen::Vector3d>& axes,
                               const std::vector<Eigen::Vector3f>& obstacles, double radius, double rate);

} // namespace pcl_spiral
