// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The closed boundaries of a surface, from its triangulation of local Delaunay stars.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** What counts as a boundary. */
struct BoundaryOptions {
  LoopMethod method = LoopMethod::HalfEdges;
  /** Flags, one per point that the graph was built from, in that order: not 0 for a boundary point. Empty: the points on
   *  free half-edges. HalfEdges keeps a loop if at least half of its points are marked. */
  std::vector<std::uint8_t> marked;
  double max_turn = 90.0; ///< theta_th of the walk, degrees
  /** Least length of a real hole, mm; shorter loops are gaps in the data. 0: an eighth of the length of the rim, and
   *  wider than largest_gap spacings. */
  double min_hole_length = 0.0;
  /** Least width (largest extent) of a real hole, mm; holes that triangles cover (ScanVoids) then count too. 0: as above. */
  double min_hole_width = 0.0;
  double largest_gap = 15.0;  ///< width in spacings: with no length set, a hole up to this width is a gap in the data
  double shortest_loop = 8.0; ///< in spacings: a loop that is shorter, or narrower than a circle of this length, is a flaw of
                              ///< the triangulation and is left out
  double largest_left_out = largest_cluster; ///< largest share of the triangles of a further part that is left out; all such parts
                                             ///< together: ten times that
  std::function<bool(double)> progress;      ///< called with the share done; false cancels
};

/** Boundaries of the largest edge-connected part of the surface: the rim first, then by decreasing length.
 *
 *  Loops that touch themselves at a point are split there. Fails if a second part is too large to be a cluster, if
 *  there is no boundary, if the rim is not among the marked points, if a walk ends before it returns to its start,
 *  or if an option is out of range.
 */
Status findBoundaryLoops(const MlsSurface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                         BoundaryReport* counts = nullptr);

/** The same; indices refer to the cloud that the surface was made from. */
Status findBoundaryLoops(const Surface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                         BoundaryReport* counts = nullptr);

/** The same with a surface made for this call. */
Status findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                         BoundaryReport* counts = nullptr);

} // namespace pcl_spiral
