// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One closed boundary loop of a scanned surface.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** What a loop bounds. */
enum class LoopType {
  Outer,  ///< the rim, the longest loop
  Inner,  ///< a real hole, large enough to be the second boundary of an annulus
  ScanGap ///< a gap in the data (shadow, reflective spot), to be bridged or refused
};

/** A closed, oriented loop. The surface lies on its left, seen from outside the material. Millimetres. */
struct BoundaryLoop {
  std::vector<std::uint32_t> indices; ///< of the points in the input cloud, in order; Surface::no_source (0xFFFFFFFF): put into a gap
  Polyline points;                    ///< the positions of these points
  Polyline curve;                     ///< the outline: a smooth curve fitted to the points, corners kept; closed
  std::vector<std::size_t> corners;   ///< entries of curve where the outline turns sharply
  LoopType type = LoopType::Outer;
  double length = 0.0; ///< of curve
};

} // namespace pcl_spiral
