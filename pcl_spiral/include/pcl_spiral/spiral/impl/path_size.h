// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Predicts how large a spiral becomes, before it is made.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/spiral/spiral_settings.h>

namespace pcl_spiral {

/** Largest number of points of a path: some 200 times the path of a tank dome of 3.3 m with turns 2 mm apart. */
constexpr double most_path_points = 1e8;

/** Size of a spiral. */
struct PathSize {
  double points = 0.0; ///< of the path
  double knots = 0.0;  ///< turns times radial lines; 0 while the lines are not known
  double turns = 0.0;
  double step_over = 0.0, step = 0.0; ///< mean distances between turns, and between points along them, mm

  /** Estimated memory at the peak: for each point of the path and each knot. */
  double bytes() const { return 200.0 * points + 150.0 * knots; }
};

/** From the \p area only: turns one flat step-over apart, with the longest moves. A hollow surface needs fewer points; every bend
 *  of the path needs more. */
PathSize roughPathSize(double area, const SpiralSettings& settings);

/** Ok, or an error with the estimate: more than \p most points, or more memory than there is. */
Status checkPathSize(const PathSize& size, double area, const SpiralSettings& settings, double most = most_path_points);

} // namespace pcl_spiral
