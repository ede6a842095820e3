/** \file
 *  One closed boundary of a scanned surface.
 */
#pragma once

#include <pcl_spiral/core/impl/polyline.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** What a loop bounds. */
enum class LoopType {
  Outer,  ///< the outer rim, the longest loop
  Inner,  ///< a real hole, large enough to be the second boundary of an annulus
  ScanGap ///< a hole in the data (shadow, reflective spot), to be bridged or refused
};

/** A closed, oriented loop: the surface lies on its left, seen from outside the material. Millimetres. */
struct BoundaryLoop {
  std::vector<std::uint32_t> indices; ///< in order, into the input cloud; Surface::no_source (0xFFFFFFFF): put into a gap
  Polyline points;                    ///< the same as positions
  Polyline curve;                     ///< the outline without the jaggedness of sampling, corners kept; closed
  std::vector<std::size_t> corners;   ///< entries of curve at which the outline turns sharply
  LoopType type = LoopType::Outer;
  double length = 0.0;                ///< of curve
};

} // namespace pcl_spiral
