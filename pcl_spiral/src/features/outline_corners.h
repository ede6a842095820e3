// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a jagged ring of points turns sharply. Private to features.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A ring rolled out into the plane; edge lengths and turns in the tangent plane are kept. One more entry than the ring
 *  has points; the last is the first point seen again after the whole round.
 */
std::vector<Eigen::Vector2d> rolledOut(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                                       std::size_t rounds);

/** A point of a ring at which it may have a corner. */
struct CornerCandidate {
  std::size_t point;
  double turn; ///< radians, positive to the left: the outline is convex there
};

/** Where smooth pieces (parabolas, at most some forty spacings long) that fit the ring best meet at an angle. Generous:
 *  later fits decide. In the ring's order.
 */
std::vector<CornerCandidate> cornerCandidates(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals,
                                              double spacing);

} // namespace pcl_spiral
