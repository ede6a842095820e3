// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The triangles that stars agree on. Private.
 */
#pragma once

#include "star_set.h"

#include <pcl_spiral/graph/impl/triangulation.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Triangles all three of whose corners have them in their stars; then, where half-edges are still free, those that two
 *  corners have and those that one has, the smallest first; then the pinholes left by disagreement, of at
 *  most \p pinhole_edges edges, closed. The order of the \p points decides only between triangles of equal size. */
Triangulation triangulate(const std::vector<Eigen::Vector3f>& points, const StarSet& stars, int pinhole_edges);

} // namespace pcl_spiral
