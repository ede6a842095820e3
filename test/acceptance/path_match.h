// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether two runs made the same path.
 */
#pragma once

#include "job.h"

#include "support/checked_path.h"

#include <Eigen/Geometry>

namespace pcl_spiral::acceptance {

/** Every field the same to the bit. */
bool sameBytes(const Path& a, const Path& b);

/** \p path under a similarity; mirrored too. */
Path mapped(const Path& path, const Eigen::Affine3d& map);

/** How far two paths, of two points and more, are from each other. Lengths as theirs, degrees. */
struct PathMatch {
  test::Place off;               ///< the point of the first farthest from the moves of the second
  test::Place missed;            ///< the point of the second farthest from the moves of the first
  double start = 0.0, end = 0.0; ///< between their first points, and their last
  double axis = 0.0;             ///< largest angle between axes after the same share of the way
};

PathMatch matched(const Path& a, const Path& b);

} // namespace pcl_spiral::acceptance
