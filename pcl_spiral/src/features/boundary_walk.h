// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Boundary points put in order by walking from one to the next. Private to features.
 */
#pragma once

#include "loop_rings.h"

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <vector>

namespace pcl_spiral {

/** How a walk goes on. */
struct WalkOptions {
  double max_turn = 0.0; ///< theta_th of Wu et al. 2025, radians
  double reach = 6.0;    ///< of a step, in spacings: the longest edge on the boundary of a triangulation
  double shortest = 8.0; ///< in spacings: a walk that ends earlier is left out
};

/** Walk from each point of \p marked to the nearest one not yet visited that turns no more than allowed, until the walk comes
 *  back to its start. Points within two spacings of a closed walk belong to it. Rings have the surface on their left.
 *  \p marked: points of the graph, ascending. \p left_out counts walks that end early. Fails if a longer one ends,
 *  and names the place.
 *  Source: Wu et al. 2025, section 1. They search neighbours by an octree; here the graph's own tree of boxes is used. */
Status walkRings(const SurfaceGraph& graph, const std::vector<std::uint32_t>& marked, const WalkOptions& options, std::vector<Ring>& rings,
                 std::size_t& left_out);

} // namespace pcl_spiral
