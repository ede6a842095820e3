// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A ball that stays clear of every point of a scan. Private to planning.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/drop_ball.h>
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/height_grid.h>
#include <pcl_spiral/spiral/path_planner.h>

#include <pcl/point_cloud.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Lifts a path over a closed scan along the direction of the fall where a point of the scan is deeper in the ball than the chord error,
 *  also on the moves between its points. Noise has no part in it: the closed surface lies over every point, and so only the fit of the path
 *  and its linear moves can bring the ball below one. */
class ScanClearance : public PathModifier {
public:
  ScanClearance(std::shared_ptr<const DropBall> ball, const HeightGrid& frame) : ball_(std::move(ball)), frame_(frame) {}

  Status modify(const Surface& surface, const SpiralSettings& settings, SpiralPath& path) const override;

private:
  std::shared_ptr<const DropBall> ball_;
  HeightGrid frame_;
};

/** A point in the ball. */
struct DeepestPoint {
  double depth = 0.0;                              ///< mm
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of the contact
};

/** The point of \p scan that is deepest in the ball of \p radius, mm, at a point of \p path or in the middle of a move; the tool is lifted
 *  before the points \p pass_begins. By the nearest point of the scan, and so by another way than ScanClearance. */
DeepestPoint deepestPoint(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<std::size_t>& pass_begins, double radius,
                          const pcl::PointCloud<pcl::PointXYZ>& scan);

} // namespace pcl_spiral
