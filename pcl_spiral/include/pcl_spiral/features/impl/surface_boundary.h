/** \file
 *  The closed boundaries of a surface, from its triangulation of local Delaunay stars.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/features/impl/surface_parts.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/impl/mls_surface.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** How boundary points are put in order. */
enum class LoopMethod {
  HalfEdges, ///< free half-edges of the triangulation are linked: loops close at corners, gaps and thick bands too
  Walk       ///< from point to nearest point, with a limit on turns, as published (Wu et al. 2025, section 1); fails there
};

/** What counts as a boundary. */
struct BoundaryOptions {
  LoopMethod method = LoopMethod::HalfEdges;
  /** A flag a point, of those the graph was built from, in their order: not 0 for a boundary point. Empty: those on the
   *  free half-edges. Linking half-edges, a loop stands when at least half of its points are marked. */
  std::vector<std::uint8_t> marked;
  double max_turn = 90.0;          ///< theta_th of the walk, degrees
  /** Shortest loop that is a real hole rather than a gap in the data, mm. 0: an eighth of the outer loop's length, and
   *  more than largest_gap spacings across. */
  double min_hole_length = 0.0;
  /** Least largest extent of a real hole, mm; then holes that the triangles close (ScanVoids) count too. 0: as above. */
  double min_hole_width = 0.0;
  double largest_gap = 15.0;       ///< across, in spacings: with no length set, a hole no larger is a gap in the data
  double shortest_loop = 8.0;      ///< in spacings: a shorter loop, or a thinner one than such a circle, is a flaw of
                                   ///< the triangulation, and left out
  double largest_left_out = largest_speck;///< share of the triangles a further part may have and still be left out; all of them
                                   ///< together, ten times that
  std::function<bool(double)> progress; ///< called with the share done; false cancels
};

/** What was left out on the way to the loops. */
struct BoundaryCounts {
  std::size_t left_out_parts = 0;     ///< specks apart from the surface
  std::size_t left_out_triangles = 0; ///< in them
  std::size_t left_out_points = 0;    ///< of these triangles alone
  std::size_t left_out_loops = 0;     ///< see shortest_loop
  std::size_t unmarked_loops = 0;     ///< less than half of their points among those marked
};

/** Boundaries of the largest edge-connected part of the surface: the outer one first, then by falling length.
 *
 *  Loops that touch themselves at a point are split there. Fails when a second part is too large to be a speck, when
 *  there is no boundary at all, when the outer one is not among the points marked, when a walk ends before it comes back,
 *  and on options out of range.
 */
Status
findBoundaryLoops(const MlsSurface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts = nullptr);

/** The same; indices are those of the cloud the surface was made of. */
Status
findBoundaryLoops(const Surface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts = nullptr);

/** The same with a surface made for the purpose. */
Status
findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts = nullptr);

} // namespace pcl_spiral
