// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A surface given by its heights over a square grid.
 */
#pragma once

#include <Eigen/Core>

namespace pcl_spiral {

/** The steepest flank of a surface that was seen along one direction, by its tangent: 75 degrees. Steeper, points and normals say little: a
 *  flank has one point in four spacings. Measured on range maps closed by the ball: from 70 to 85 degrees all work alike. */
constexpr double steepest_tangent = 3.7320508075688773;

/** Nodes of a square grid, and the frame (u, v, h) of the heights over it. A right-handed frame; lengths in mm. */
struct HeightGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< node (0, 0), at height 0
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns: u, v, h; h points away from the material
  double cell = 1.0;                                  ///< distance of the nodes

  Eigen::Vector3d inside(const Eigen::Vector3d& place) const { return axes.transpose() * (place - origin); } ///< (u, v, h) of a place.
  Eigen::Vector3d outside(const Eigen::Vector3d& place) const { return origin + axes * place; }              ///< The place of (u, v, h).
  Eigen::Vector3d along() const { return axes.col(2); }                                                      ///< The direction of h.
};

} // namespace pcl_spiral
