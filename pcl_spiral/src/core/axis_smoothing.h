// SPDX-License-Identifier: BSD-3-Clause
// Smoothing spline of axes over the arc length.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Axes at \p arc_lengths (which must not fall), smoothed; see smoothAxes in core/smooth_axes.h. */
std::vector<Eigen::Vector3d> splineOfAxes(const std::vector<double>& arc_lengths, const std::vector<Eigen::Vector3d>& wanted, double length,
                                          double max_deviation);

} // namespace pcl_spiral
