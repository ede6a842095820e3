// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A closed boundary loop of a scanned surface, and how it is found.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <pcl/types.h>

#include <cstddef>
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
  pcl::Indices indices;             ///< of the points in the input cloud, in order; pcl::UNAVAILABLE (-1): put into a gap
  Polyline points;                  ///< the positions of these points
  Polyline curve;                   ///< the outline: a smooth curve fitted to the points, corners kept; closed
  std::vector<std::size_t> corners; ///< entries of curve where the outline turns sharply
  LoopType type = LoopType::Outer;  ///< what it bounds
  double length = 0.0;              ///< of curve
};

/** Which measure makes a boundary point. */
enum class BoundaryCriterion {
  Centroid,   ///< offset above its threshold, as published (Wu et al. 2025); misses re-entrant corners
  LargestGap, ///< gap above its threshold, as in pcl::BoundaryEstimation
  Combined    ///< offset and gap, each divided by its threshold, sum to more than 1.7; or the gap exceeds 0.9 of its
              ///< threshold
};

/** How boundary points are put in order. */
enum class LoopMethod {
  HalfEdges, ///< links free half-edges of the triangulation: loops also close at corners, gaps and thick bands
  Walk       ///< from point to nearest point, with limited changes of direction, as published (Wu et al. 2025, section 1); fails there
};

/** What was left out before the loops were made. */
struct BoundaryReport {
  std::size_t left_out_parts = 0;     ///< clusters apart from the surface
  std::size_t left_out_triangles = 0; ///< in them
  std::size_t left_out_points = 0;    ///< of these triangles only
  std::size_t left_out_loops = 0;     ///< see shortest_loop
  std::size_t unmarked_loops = 0;     ///< with less than half of their points marked
};

/** \deprecated Use BoundaryReport. */
using BoundaryCounts [[deprecated("use BoundaryReport")]] = BoundaryReport;

} // namespace pcl_spiral
