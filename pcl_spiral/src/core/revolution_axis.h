// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The axis a surface goes round, from points and normals.
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** An axis, and how well a surface goes round it. Angles in radians. */
struct RevolutionAxis {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< foot of the points' mean on the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); ///< unit; its largest component is positive
  double turning = 0.0;                                 ///< rms share of the normals round the axis: 0 for a surface of revolution
  double radial = 0.0;                                  ///< rms share of the normals out of the axis, or towards it: 1 for a cylinder
  double uncertainty = 0.0;                             ///< of the direction, as if each point were by itself; a sphere's is about 1
};

/** Axis that the normals of a column pass closest to. \p weights count the points; not negative.
 *
 *  Least squares of two shares of each normal n at x, for the axis through c along d: of n (d x (x - c)) / |d
 * x (x - c)|, 0 on any surface of revolution (Pottmann, Randrup, Rotational and helical surface approximation
 * for reverse engineering, Computing 60, 1998), and of n d less a cubic of the height along d, which holds
 * short wide columns and leaves waists free. Points far off, as on a boss, count less (Cauchy). Begun from
 * each principal axis of the normals; that which leaves least wins, and of some that leave about as much (a cylinder is a
 * piece of a huge ring, too) that with the least uncertainty. Empty where there are fewer than 10 points, or no end is
 * found. */
std::optional<RevolutionAxis> fitRevolutionAxis(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                                                const std::vector<double>& weights);

} // namespace pcl_spiral
