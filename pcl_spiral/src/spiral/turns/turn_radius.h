// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How sharply a path turns. Private to spiral.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

#include <cstddef>

namespace pcl_spiral {

/** In step-overs. */
struct SharpTurns {
  double radius = 0.0;       ///< all but 0.1 % of the path turn no sharper
  std::size_t sharpest = 0;  ///< point of the path that turns most sharply
  double least_radius = 0.0; ///< there
};

/** Radius of the circle through a place of \p path and those 0.12 step-overs before and behind it, in the metric there. The first
 *  \p rim step-overs of the path do not count: corners of the rim are the part's. */
SharpTurns sharpTurns(const LinkedPath& path, double rim);

} // namespace pcl_spiral
