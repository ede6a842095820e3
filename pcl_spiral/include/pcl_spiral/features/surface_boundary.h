/** \file
 *  The closed boundaries of a surface, from its triangulation of local Delaunay stars.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/search/surface_graph.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** What counts as a boundary. */
struct BoundaryOptions {
  /** Shortest loop that is a real hole rather than a gap in the data, mm. 0: an eighth of the outer loop's length, and
   *  more than largest_gap spacings across. */
  double min_hole_length = 0.0;
  double largest_gap = 15.0;       ///< across, in spacings: with no length set, a hole no larger is a gap in the data
  double shortest_loop = 8.0;      ///< in spacings: a shorter loop is a flaw of the triangulation, and left out
  double largest_left_out = 0.02;  ///< share of the triangles a further part may have and still be left out
};

/** What was left out on the way to the loops. */
struct BoundaryCounts {
  std::size_t left_out_parts = 0;     ///< specks apart from the surface
  std::size_t left_out_triangles = 0; ///< in them
  std::size_t left_out_loops = 0;     ///< shorter than shortest_loop
};

/** Boundaries of the largest edge-connected part of the surface: the outer one first, then by falling length.
 *
 *  Loops that touch themselves at a point are split there. Fails when a second part is too large to be a speck, when
 *  there is no boundary at all, and on options out of range.
 */
Status
findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts = nullptr);

} // namespace pcl_spiral
