// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points that lie off the planes of their neighbours. Private.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include "local_shape.h"
#include "star_set.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** What one pass over all neighbourhoods found for every point. */
struct PointShapes {
  std::vector<Eigen::Vector3f> normals; ///< of their neighbours' planes
  std::vector<float> radii;             ///< distance to the k-th neighbour
  std::vector<float> heights;           ///< over the plane, along the normal
  std::vector<float> offsets;           ///< of the neighbours' mean along the plane, in radii
  int neighbours = 0;                   ///< k

  double spacing(std::size_t i) const { return evenSpacing(radii[i], neighbours); }
};

/** Isolated points off the surface: high over the plane of their neighbours, none of which is nearly as high. Along a
 *  crease points are high too, but not alone. Points farther than \p far from their neighbours count as well: they lie in
 *  the plane that they make with the rest. Original indices, ascending. */
std::vector<std::uint32_t> isolatedPoints(const PointBlocks& blocks, const StarSet& stars, const PointShapes& shapes, double far);

/** Points whose height differs from the mean of their neighbours by more than noise: where the curvature of the surface
 *  changes, or spikes. In the order of the blocks, ascending. */
std::vector<std::uint32_t> spikeCandidates(const StarSet& stars, const PointShapes& shapes);

} // namespace pcl_spiral
