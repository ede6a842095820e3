// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The points along the boundary of a triangulation. Private to features.
 */
#pragma once

#include "loop_rings.h"

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A point near a ring. */
struct EdgePoint {
  Eigen::Vector3d position;
  double place; ///< of its foot on the ring, mm from the ring's first point
};

/** All points of the cloud near \p ring, including its own, in the order of their places.
 *
 *  The ring alone does not show the edge: at a re-entrant corner its edges span the notch, and the points of the true
 *  edge lie behind them.
 */
std::vector<EdgePoint> edgePoints(const SurfaceGraph& graph, const Ring& ring);

} // namespace pcl_spiral
