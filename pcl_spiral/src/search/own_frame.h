// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points in a frame of their own. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** The points about their mean along their principal axes, longest first, each axis turned to the side on which the third moment
 *  is positive. Except for rounding, the result is the same for a part that is moved or mirrored. If the points are equally wide in
 *  two directions, or equally heavy on both sides, rounding decides. */
std::vector<Eigen::Vector3f> inOwnFrame(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl_spiral
