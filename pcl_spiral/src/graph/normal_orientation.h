// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One side for all normals. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include "star_set.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Which normals to flip so that neighbours agree: along a minimum spanning forest of the stars' edges, weighted by
 *  how far the two normals are from parallel (Hoppe et al. 1992), by union-find with parity. */
std::vector<std::uint8_t> consistentSigns(const std::vector<Eigen::Vector3f>& normals, const StarSet& stars);

/** Flip all normals together (\p flipped) if needed, so that they leave the material: as given, or towards the view
 *  point, or towards +z, or, if +z does not decide, to the convex side. Points whose neighbourhood is wider than
 *  \p farthest are ignored: they belong to no surface. */
OuterSide chooseOuterSide(const PointBlocks& blocks, const std::vector<Eigen::Vector3f>& normals, const std::vector<float>& radii,
                          double farthest, const SurfaceGraphOptions& options, std::vector<std::uint8_t>& flipped);

} // namespace pcl_spiral
