// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tool axes that turn smoothly and no faster than a limit along a path. Angles in radians, lengths in the unit of the
 *  points.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>

namespace pcl_spiral {

/** How far axes may be changed, and for what. */
struct AxisFieldOptions {
  double smoothing_length = 0.0; ///< what is shorter along the path is smoothed away; 0: nothing is
  double max_deviation = 0.05;   ///< from the wanted axes, that smoothing may cause in the mean over its length
  double max_rate = 0.0;         ///< largest turn per length of path, kept on every move; 0: no limit
};

/** Axes of a path, one a point, and what they cost. */
struct SmoothAxes {
  std::vector<Eigen::Vector3d> axes; ///< unit
  double largest_deviation = 0.0;    ///< from the wanted axis, at any point
  std::size_t deviating_points = 0;  ///< points where it is above max_deviation
  double largest_change = 0.0;       ///< turn between neighbouring points
  double largest_rate = 0.0;         ///< turn per length of path
};

/** Axes near \p wanted (unit, one a point of the path \p points).
 *
 *  First a smoothing spline along the arc length s: the least of the integral of |a - wanted|^2 + L^4 |a''|^2, with
 *  natural ends, L the smoothing length. A wave of length 2 pi l keeps the share 1 / (1 + (L / l)^4). Where the axes
 *  would leave the wanted ones by more than max_deviation in the mean over L, as where a tilt spins about the pole of a
 *  dome within L, the wanted ones count more: L is shorter there.
 *
 *  Then the rate: a pass forward turns each axis no farther from the one before than allowed, and one backward likewise;
 *  their mean, the same from either end, replaces both, until it keeps the limit. Where a tilt spins faster it is drawn
 *  in towards the middle, so that the axis goes through the pole without a jump; a step becomes a ramp. Points at one
 *  place share an axis where there is a limit.
 *
 *  Time is linear in the number of points; the same for any number of threads.
 *  Source: Reinsch 1967; Green and Silverman 1994, section 2.3.
 *  \throws std::invalid_argument when points and axes differ in number, or an option is out of range */
SmoothAxes smoothAxes(const Polyline& points, const std::vector<Eigen::Vector3d>& wanted, const AxisFieldOptions& options);

/** Moves of a path on which unit \p directions, one a point, turn faster than \p max_rate per length of path. */
std::size_t movesTurningFaster(const Polyline& points, const std::vector<Eigen::Vector3d>& directions, double max_rate);

/** The place where an axis leans most off the normal. */
struct AxisLean {
  double angle = 0.0;
  std::size_t point = 0;
};

/** \p normals and \p axes unit, as many of the one as of the other. */
AxisLean largestLean(const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& axes);

/** Whether axes of largest \p lean come within a degree of the surface, or into it, where \p wanted ones did not. */
bool liesInSurface(const AxisLean& lean, const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& wanted);

} // namespace pcl_spiral
