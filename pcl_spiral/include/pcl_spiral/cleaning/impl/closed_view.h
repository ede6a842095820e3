// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a scan closed by a ball along one direction.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/drop_ball.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/height_grid.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Result of closeByBall. Lengths in mm. */
struct ClosedView {
  HeightGrid grid;                      ///< of ball and closing
  std::shared_ptr<const DropBall> ball; ///< on the points as given, and the obstacles
  std::vector<Eigen::Vector3f> points;  ///< of the closed surface: nodes of the grid
  double spacing = 0.0;                 ///< of the points as given
  std::size_t covered = 0;              ///< points as given that lie deeper under it than a cell: in folds and below overhangs
};

/** Centre of the smallest box, along the axes, of \p points. */
Eigen::Vector3d middleOf(const std::vector<Eigen::Vector3f>& points);

/** Closes \p points, finite and all different, along the unit vector \p along by a ball of \p radius, mm: what a ball that comes down
 *  that way can touch, with walls as flanks of steepest_tangent, without what hangs together by less than half the radius, and without
 *  where \p obstacles keep the ball away. The result is raised by a ball of radius \p rounding, mm, that rolls on it. Fails on fewer than
 *  50 points, on a ball smaller than the spacing of the points, and if nothing is left. */
Status closeByBall(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& obstacles, const Eigen::Vector3d& along,
                   double radius, double rounding, ClosedView& view);

} // namespace pcl_spiral
