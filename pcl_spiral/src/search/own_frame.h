// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points in a frame of their own. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** The points about their mean along their principal axes, longest first, each turned to the side on which the third moment
 *  is positive: but for rounding the same for a part that is moved or mirrored. Where the points are as wide in two
 *  directions, or as heavy on both sides, rounding decides. */
std::vector<Eigen::Vector3f> inOwnFrame(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl_spiral
