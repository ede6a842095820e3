// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Polylines in space, double precision.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** An ordered sequence of points. A closed polyline does not repeat its first point. Lengths in the unit of the points. */
using Polyline = std::vector<Eigen::Vector3d>;

/** Length of the polyline. With \p closed, the segment from the last point to the first counts too. */
double length(const Polyline& line, bool closed = false);

/** Arc length at each point, starting at 0. With \p closed, one more entry at the end has the whole length. */
std::vector<double> arcLengths(const Polyline& line, bool closed = false);

/** \p count points at equal arc length. Open: both ends kept. Closed: starts at the first point and never repeats it. */
Polyline resampled(const Polyline& line, std::size_t count, bool closed = false);

} // namespace pcl_spiral
