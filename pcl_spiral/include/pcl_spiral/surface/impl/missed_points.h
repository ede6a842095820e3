// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a scan that stand out of its fitted surface.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace pcl_spiral {

/** Points of a scan that stand out of the fitted surface by far more than the noise: an edge, a ridge or a step with too few points. */
struct MissedPoints {
  double noise = 0.0; ///< standard deviation of the points about the surface, mm, by their median: shape that it misses has no part in it
  double least = 0.0; ///< height from which a point counts, mm
  std::size_t count = 0;
  double height = 0.0;                             ///< of the highest, mm
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of that point
};

} // namespace pcl_spiral
