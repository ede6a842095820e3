// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tool axes that turn smoothly and no faster than a limit along a path. Angles in radians, lengths in the unit of the
 *  points.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>

namespace pcl_spiral {

/** How axes are smoothed, and how far they may be changed. */
struct AxisFieldOptions {
  double smoothing_length = 0.0; ///< waves shorter than this along the path are smoothed away; 0: no smoothing
  double max_deviation = 0.05;   ///< from the wanted axes, caused by smoothing, in the mean over its length
  double max_rate = 0.0;         ///< largest turn per length of path, kept on every move; 0: no limit
};

/** Axes of a path, one per point, and how far they were changed. */
struct SmoothAxes {
  std::vector<Eigen::Vector3d> axes; ///< unit
  double largest_deviation = 0.0;    ///< from the wanted axis, at any point
  std::size_t deviating_points = 0;  ///< points where it is above max_deviation
  double largest_change = 0.0;       ///< turn between neighbouring points
  double largest_rate = 0.0;         ///< turn per length of path
};

/** Axes near \p wanted (unit, one per point of the path \p points).
 *
 *  First a smoothing spline along the arc length s: the minimum of the integral of |a - wanted|^2 + L^4 |a''|^2, with
 *  natural ends, L the smoothing length. A wave of length 2 pi l keeps the share 1 / (1 + (L / l)^4). If the axes
 *  would deviate from the wanted ones by more than max_deviation in the mean over L, as when a tilt spins about the pole of a
 *  dome within L, the wanted ones count more: L is shorter there.
 *
 *  Then the rate: a forward pass turns each axis no farther from the one before than allowed, and a backward pass does the same;
 *  their mean, the same from either end, replaces both, until it keeps the limit. A tilt that spins faster is drawn
 *  in towards the middle, so that the axis goes through the pole without a jump. A step becomes a ramp. Points at one
 *  place share an axis if there is a limit.
 *
 *  Time is linear in the number of points. The result is the same for any number of threads.
 *  Source: Reinsch 1967; Green and Silverman 1994, section 2.3.
 *  \throws std::invalid_argument when points and axes differ in number, a point is not finite, or an option is out of range */
SmoothAxes smoothAxes(const Polyline& points, const std::vector<Eigen::Vector3d>& wanted, const AxisFieldOptions& options);

/** Moves of a path on which unit \p directions, one per point, turn faster than \p max_rate per length of path. */
std::size_t movesTurningFaster(const Polyline& points, const std::vector<Eigen::Vector3d>& directions, double max_rate);

/** The place where an axis leans most from the normal. */
struct AxisLean {
  double angle = 0.0;
  std::size_t point = 0;
};

/** \p normals and \p axes unit, in equal number. */
AxisLean largestLean(const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& axes);

/** Whether axes with the largest \p lean come within a degree of the surface, or into it, where the \p wanted ones did not. */
bool liesInSurface(const AxisLean& lean, const std::vector<Eigen::Vector3d>& normals, const std::vector<Eigen::Vector3d>& wanted);

} // namespace pcl_spiral
