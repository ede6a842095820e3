// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Boundaries as published: flags by the centroid of the neighbours, walked over. Private to spiral.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** What makes a boundary point, and how far a walk over them may turn. */
struct PublishedLoopOptions {
  int neighbours = 32;                  ///< in a neighbourhood, the point itself not counted
  double offset_threshold = 0.31;       ///< of BoundaryEvidence::offset
  double max_turn = 90.0;               ///< theta_th, degrees
  std::function<bool(double)> progress; ///< called with the share done; false cancels
};

/** A flag a point, of those \p graph was built from, in their order: 1 where the score of Wu et al. 2025,
 * equation (1), kappa = exp(mu lambda), is above its threshold. exp grows with lambda, so lambda alone is
 * compared, made dimensionless by the radius of the neighbourhood; mu then only names the threshold. */
std::vector<std::uint8_t> centroidFlags(const SurfaceGraph& graph, int neighbours, double offset_threshold);

/** Walk over the flagged points to closed loops (Wu et al. 2025, section 1). Fails, and names the place,
 * where the walk ends before it comes back: at corners sharper than the largest turn, at gaps, in bands of
 * several rows, and at false flags inside that lie close together. Nothing is mended. */
Status publishedLoops(const SurfaceGraph& graph, const PublishedLoopOptions& options, std::vector<BoundaryLoop>& loops);

} // namespace pcl_spiral
