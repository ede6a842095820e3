// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Compares the paths of two runs.
 */
#pragma once

#include "job.h"

#include "support/checked_path.h"

#include <Eigen/Geometry>

namespace pcl_spiral::acceptance {

/** Whether every field is the same bit for bit. */
bool sameBytes(const Path& a, const Path& b);

/** \p path under a similarity, also mirrored. */
Path mapped(const Path& path, const Eigen::Affine3d& map);

/** Distance of two paths of at least two points. Lengths in their unit, degrees. */
struct PathMatch {
  test::Place off;               ///< the point of the first farthest from the moves of the second
  test::Place missed;            ///< the point of the second farthest from the moves of the first
  double start = 0.0, end = 0.0; ///< between their first points, and their last
  double axis = 0.0;             ///< largest angle between axes after the same share of the length
};

PathMatch matched(const Path& a, const Path& b);

} // namespace pcl_spiral::acceptance
