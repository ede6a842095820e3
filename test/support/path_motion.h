// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Motion of a path: radius of its turns, reversals, and the machining time. Lengths in mm.
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

/** Points along the straight moves between the points of \p line, with both ends, \p step apart or slightly more. */
Points atEqualSteps(const Points& line, double step);

/** Radius of the circle through three points; infinite if they are on a line. */
double circleRadius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/** Turning radii in pitches: circles through the points 0.12 pitch before and after, every 0.06. */
struct TurningReport {
  Place least;
  Place smallest; ///< a thousandth of the path has a smaller radius
};
TurningReport turningRadii(const Points& line, double pitch);

/** Where the feed turns by more than 150 degrees within two pitches. */
struct ReversalReport {
  std::size_t count = 0; ///< separate runs of such turns
  double share = 0.0;    ///< of the length
  Place first;
};
ReversalReport reversals(const Points& line, double pitch);

/** Seconds from rest to rest at no more than \p speed, mm/s, with accelerations of no more than \p
 * acceleration, mm/s^2, along the path and across it: forward and backward over points \p window / 3 apart,
 * curvature by the circle through the points \p window before and after, with a radius of at least a tenth of it. */
double machineTime(const Points& line, double speed, double acceleration, double window);

} // namespace pcl_spiral::test
