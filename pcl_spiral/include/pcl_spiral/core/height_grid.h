// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A surface given by its heights over a square grid.
 */
#pragma once

#include <Eigen/Core>

namespace pcl_spiral {

/** The steepest flank of a surface that was seen along one direction, by its tangent: 75 degrees. There a flank has one point in four
 *  spacings, as few as a surface may have: triangles reach over six. Other angles were not measured with the rules as they are now. */
constexpr double steepest_tangent = 3.7320508075688773;

/** Nodes of a square grid, and the frame (u, v, h) of the heights over it. A right-handed frame; lengths in mm. */
struct HeightGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< node (0, 0), at height 0
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< columns: u, v, h; h points away from the material
  double cell = 1.0;                                  ///< distance of the nodes
  double reached_by = 0.0;                            ///< radius of a ball that reaches every place; 0: none is known

  /** Whether a ball of \p radius, mm, reaches every place. */
  bool isReachedBy(double radius) const { return radius <= reached_by * (1.0 + 1e-9); }

  Eigen::Vector3d inside(const Eigen::Vector3d& place) const { return axes.transpose() * (place - origin); } ///< (u, v, h) of a place.
  Eigen::Vector3d outside(const Eigen::Vector3d& place) const { return origin + axes * place; }              ///< The place of (u, v, h).
  Eigen::Vector3d along() const { return axes.col(2); }                                                      ///< The direction of h.
};

} // namespace pcl_spiral
