// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tool axis from surface normals and feed directions. Angles in radians, lengths in the unit of the points.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral {

/** Unit feed direction at each point: that of the parabola through the point and its distinct neighbours (central
 *  difference at equal spacing), made tangential to \p normals. Repeated points share one direction. Zero
 * if there is none (all points the same, or the path runs along the normal). \throws std::invalid_argument
 * when points and normals differ in number. */
std::vector<Eigen::Vector3d> feedDirections(const Polyline& points, const std::vector<Eigen::Vector3d>& normals);

/** Axis at one point: the normal turned by \p lead about the conormal, then by \p side_tilt about the feed,
 *  cos lead (cos side_tilt n + sin side_tilt f x n) + sin lead f. A positive side tilt leans to the right of
 *  travel, seen from outside, a positive lead forward. \p normal and \p feed unit and perpendicular; without a feed
 *  (zero) the axis is the normal. */
Eigen::Vector3d tiltedAxis(const Eigen::Vector3d& normal, const Eigen::Vector3d& feed, double side_tilt, double lead);

/** tiltedAxis at every point of a path, with its feed directions. The angle between axis and normal is
 *  acos(cos \p side_tilt cos \p lead). \p normals unit, one per point. smoothAxes in core/smooth_axes.h turns them into axes
 *  that a machine can follow.
 *  \throws std::invalid_argument when points and normals differ in number, or an angle is not under 90 degrees */
std::vector<Eigen::Vector3d> tiltedAxes(const Polyline& points, const std::vector<Eigen::Vector3d>& normals, double side_tilt, double lead);

} // namespace pcl_spiral
