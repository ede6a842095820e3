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
  double turning = 0.0;                                 ///< rms component of the normals round the axis: 0 for a surface of revolution
  double radial = 0.0;                                  ///< rms component of the normals towards or away from the axis: 1 for a cylinder
  double uncertainty = 0.0;                             ///< of the direction, with independent errors of the points; about 1 for a sphere
};

/** Axis that the normals of a column pass closest to. \p weights count the points; they must not be negative.
 *
 *  Least squares of two components of each normal n at x, for the axis through c along d: of n (d x (x - c)) / |d
 * x (x - c)|, 0 on any surface of revolution (Pottmann, Randrup, Rotational and helical surface approximation
 * for reverse engineering, Computing 60, 1998), and of n d less a cubic of the height along d. The cubic holds
 * short wide columns and allows waists. Points far from the fit, as on a boss, count less (Cauchy). The search
 * starts from each principal axis of the normals; the smallest residual wins. Of several nearly equal ones (a cylinder is also a
 * piece of a huge ring) the one with the least uncertainty wins. Empty if there are fewer than 10 points, or if no search
 * converges. */
std::optional<RevolutionAxis> fitRevolutionAxis(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                                                const std::vector<double>& weights);

} // namespace pcl_spiral
