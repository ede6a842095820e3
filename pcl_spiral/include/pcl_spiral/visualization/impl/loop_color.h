// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The colours of boundary loops, in pictures and viewers.
 */
#pragma once

#include <pcl_spiral/features/boundary_loop.h>

#include <array>

namespace pcl_spiral {

/** Red, green and blue, 0 to 1. */
using Color = std::array<double, 3>;

/** Red for the outer rim, orange for an inner loop, magenta for a gap of the scan. */
constexpr Color
loopColor(LoopType type)
{
  switch (type) {
  case LoopType::Inner:
    return {0.93, 0.48, 0.05};
  case LoopType::ScanGap:
    return {0.75, 0.15, 0.70};
  default:
    return {0.80, 0.11, 0.13};
  }
}

} // namespace pcl_spiral
