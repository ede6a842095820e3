// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How sharply a path bends. Private to spiral.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

#include <cstddef>

namespace pcl_spiral {

/** In step-overs. */
struct SharpTurns {
  double radius = 0.0;       ///< 0.1 % of the path bends more sharply than this
  std::size_t sharpest = 0;  ///< point of the sharpest bend of the path
  double least_radius = 0.0; ///< there
};

/** Radius of the circle through a place of \p path and the places 0.12 step-overs before and after it, in the metric there. The first
 *  \p rim step-overs of the path do not count, because corners of the rim belong to the part. */
SharpTurns sharpTurns(const LinkedPath& path, double rim);

} // namespace pcl_spiral
