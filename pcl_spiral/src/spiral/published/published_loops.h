// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Boundaries as published: a walk over points flagged by the centroid of their neighbours. Private to spiral.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** The criterion of boundary points, and the largest turn of a walk over them. */
struct PublishedLoopOptions {
  int neighbours = 32;                  ///< in a neighbourhood, the point itself not counted
  double offset_threshold = 0.31;       ///< of BoundaryEvidence::offset
  double max_turn = 90.0;               ///< theta_th, degrees
  std::function<bool(double)> progress; ///< called with the share done; false cancels
};

/** One flag a point of \p graph, in the order of its input: 1 where the score of Wu et al. 2025,
 *  equation (1), kappa = exp(mu lambda), is above its threshold. exp grows with lambda, so only lambda is
 *  compared, divided by the radius of the neighbourhood to have no unit; mu then only scales the threshold. */
std::vector<std::uint8_t> centroidFlags(const SurfaceGraph& graph, int neighbours, double offset_threshold);

/** Walk over the flagged points to closed loops (Wu et al. 2025, section 1). If the walk ends before it comes
 *  back, it fails and names the place: at corners sharper than the largest turn, at gaps, in bands of
 *  several rows, and at wrong flags inside that lie close together. Nothing is repaired. */
Status publishedLoops(const SurfaceGraph& graph, const PublishedLoopOptions& options, std::vector<BoundaryLoop>& loops);

} // namespace pcl_spiral
