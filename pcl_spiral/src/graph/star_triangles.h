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

/** Triangles that are in the stars of all three corners. Then, where half-edges are still free, those in the stars of two corners,
 *  and those in one, the smallest first. Then the pinholes that disagreement leaves, of at
 *  most \p pinhole_edges edges, are closed. The order of the \p points decides only between triangles of equal size. */
Triangulation triangulate(const std::vector<Eigen::Vector3f>& points, StarSet stars, int pinhole_edges);

} // namespace pcl_spiral
