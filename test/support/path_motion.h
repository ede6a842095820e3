// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How a path moves: sharpness of its turns, reversals, and the time a machine takes. Lengths in mm.
 */
#pragma once

#include "support/checked_path.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

using Points = std::vector<Eigen::Vector3d>;

/** Length of the moves between consecutive points. */
double lineLength(const Points& line);

/** Points along the straight moves between \p line's, both ends kept, \p step apart or the least more. */
Points atEqualSteps(const Points& line, double step);

/** Radius of the circle through three points; infinite where they are in line. */
double circleRadius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/** Turning radii in pitches: circles through the points 0.12 pitch before and after, every 0.06. */
struct TurningFigures {
  Place least;
  Place smallest; ///< that a thousandth of the path is sharper than
};
TurningFigures turningRadii(const Points& line, double pitch);

/** Where the feed turns by more than 150 degrees within two pitches. */
struct ReversalFigures {
  std::size_t count = 0; ///< unbroken stretches
  double share = 0.0;    ///< of the length
  Place first;
};
ReversalFigures reversals(const Points& line, double pitch);

/** Seconds from rest to rest at no more than \p speed, mm/s, with accelerations of no more than \p
 * acceleration, mm/s^2, along the path and across it: forward and backward over points \p window / 3 apart,
 * curvature by the circle through the points \p window before and after, never under a tenth of it. */
double machineTime(const Points& line, double speed, double acceleration, double window);

} // namespace pcl_spiral::test
