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

#include <memory>

namespace pcl_spiral {

/** Lifts a path over a closed scan along the direction of the fall where a point of the scan is deeper in the ball than the tolerance of
 *  all checks (gougeTolerance), also on the moves between its points. */
class ScanClearance : public PathModifier {
public:
  ScanClearance(std::shared_ptr<const DropBall> ball, const HeightGrid& frame) : ball_(std::move(ball)), frame_(frame) {}

  Status modify(const Surface& surface, const SpiralSettings& settings, SpiralPath& path) const override;

private:
  std::shared_ptr<const DropBall> ball_;
  HeightGrid frame_;
};

/** Ok, or Failed with the deepest place: a point of \p scan lies deeper than \p allowed, mm, in the ball of \p radius at a point of \p path
 *  or in the middle of a move. By the nearest point of the scan, and so by another way than ScanClearance. */
Status checkClear(const pcl::PointCloud<ToolpathPoint>& path, double radius, double allowed, const pcl::PointCloud<pcl::PointXYZ>& scan);

} // namespace pcl_spiral
