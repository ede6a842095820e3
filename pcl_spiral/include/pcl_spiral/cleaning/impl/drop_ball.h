// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ball let down onto points.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Heights at which a ball that comes down along one direction meets the first of many points: a drop cutter, and, for all places, the
 *  dilation of the points by the ball. Lengths in mm, in a frame (u, v, h) in which h is against the direction of the fall.
 *
 *  Memory: 28 bytes a point, twice the points while it is made. A call looks at the cell in the middle first, and then passes over all
 *  cells whose highest point cannot be met any more. */
class DropBall {
public:
  /** \p points in the frame; a ball of \p radius above 0. */
  DropBall(std::vector<Eigen::Vector3d> points, double radius);

  double radius() const { return radius_; } ///< Of the ball, mm.
  /** Height of the centre of the ball over (\p u, \p v) that touches the first point; minus infinity if there is none below it. */
  double height(double u, double v) const;
  /** The same if points may be \p depth deep in the ball. */
  double height(double u, double v, double depth) const;
  /** The points, in the order of their cells. */
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  /** Corners of the smallest box of all points, (u, v). */
  const Eigen::Vector2d& low() const { return low_; }
  const Eigen::Vector2d& high() const { return high_; } ///< \copydoc low

private:
  std::size_t cellOf(const Eigen::Vector3d& point) const;

  std::vector<Eigen::Vector3d> points_;
  double radius_;
  double cell_ = 0.0; ///< edge of a cell, mm
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero(), high_ = Eigen::Vector2d::Zero();
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begin_; ///< first point of each cell
  std::vector<double> top_;          ///< highest point of each cell
};

} // namespace pcl_spiral
