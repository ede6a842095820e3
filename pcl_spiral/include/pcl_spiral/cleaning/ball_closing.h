// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Closes a scan that was taken from one side, so that a ball can touch every place of it.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/closed_view.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/status.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace pcl_spiral {

/** Figures of BallClosing. */
struct ClosingReport {
  std::size_t points = 0; ///< finite and all different
  std::size_t covered =
      0;                ///< of them, deeper under the closed surface than its cell: in folds and under overhangs that the ball cannot enter
  double spacing = 0.0; ///< of the points, mm
  double cell = 0.0;    ///< distance of the points of the closed surface, across the direction, mm
};

/** \deprecated Use ClosingReport. */
using ClosingFigures [[deprecated("use ClosingReport")]] = ClosingReport;

/** Closes a scan by a ball that comes down along one direction: the result is the surface that the ball can touch from there. Steps whose
 *  side was not seen, folds and crevices narrower than the ball are bridged by its shape, thin things stay, and walls become flanks of 75
 *  degrees: material that the scan does not show is never cut, and what the ball cannot enter stays as stock. (Closing: Serra 1982, Image
 *  Analysis and Mathematical Morphology.)
 *
 *  For scans from one side, as of a depth camera, that are refused otherwise: "handle", "narrow strip", "crosses itself", several parts
 *  that are one. SpiralPlanner::setBallClosing does it, and lifts the finished path off every point of the scan. By hand:
 *  \code
 *  BallClosing<pcl::PointXYZ> closing;
 *  closing.setInputCloud(scan);
 *  closing.setDirection({0, 0, 1});       // from where the tool comes
 *  closing.setToolRadius(5.0);
 *  pcl::PointCloud<pcl::PointXYZ>::Ptr closed(new pcl::PointCloud<pcl::PointXYZ>);
 *  closing.compute(*closed);
 *  ScannedSurface<pcl::PointXYZ> surface;  // or any stage
 *  surface.setInputCloud(closed);
 *  surface.setHeightGrid(closing.getHeightGrid());
 *  \endcode
 *  setIndices: only these points. The result does not depend on the order of the points or on the number of threads. Lengths in mm. */
template <typename PointT>
class BallClosing : public pcl::PCLBase<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<BallClosing>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const BallClosing>; ///< A shared pointer to a constant one.

  /** Radius of the ball, mm; must be set. */
  void setToolRadius(double radius) { radius_ = radius; }
  double getToolRadius() const { return radius_; } ///< The value of setToolRadius.

  /** Raises the closed surface by a ball of this radius, mm, that rolls on it; 0, the default: not. Edges are then no sharper than that.
   *  The ball of the tool over the scan, and a ball smaller by the rounding over the result, have the same centre. */
  void setRounding(double radius) { rounding_ = radius; }
  double getRounding() const { return rounding_; } ///< The value of setRounding.

  /** Direction from the material towards the tool, of any length. Without it: from the middle of the scan to the view point. */
  void setDirection(const Eigen::Vector3d& direction) { direction_ = direction; }
  const std::optional<Eigen::Vector3d>& getDirection() const { return direction_; } ///< The value of setDirection.

  /** Place of the sensor, mm. Without it, and without a direction: that of the cloud (sensor_origin_) if it is not zero, else +z counts. */
  void setViewPoint(const Eigen::Vector3d& point) { view_point_ = point; }
  const std::optional<Eigen::Vector3d>& getViewPoint() const { return view_point_; } ///< The value of setViewPoint.

  /** Further points that the ball must not touch, such as the whole scan if the input is a part of it: where they are in its way, the
   *  surface ends. Null, the default: none. */
  void setObstacles(const typename pcl::PointCloud<PointT>::ConstPtr& obstacles) { obstacles_ = obstacles; }
  const typename pcl::PointCloud<PointT>::ConstPtr& getObstacles() const { return obstacles_; } ///< The value of setObstacles.

  /** Closes the scan. \p closed is empty on failure: no cloud, no finite point, no radius, a ball not larger than the point spacing, a
   *  direction of no length, fewer than 50 points, or nothing that the ball reaches. */
  void compute(pcl::PointCloud<pcl::PointXYZ>& closed);

  /** The grid whose nodes the points of the last result are. */
  const HeightGrid& getHeightGrid() const { return view_.grid; }
  const ClosingReport& getReport() const { return figures_; }                                     ///< Figures of the last result.
  [[deprecated("use getReport")]] const ClosingReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.
  /** The ball over the points as given, and the obstacles, in the frame of getHeightGrid. */
  const std::shared_ptr<const DropBall>& getDropBall() const { return view_.ball; }

  const Status& getStatus() const { return status_; } ///< Result of the last compute.
  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

private:
  Status run();

  double radius_ = 0.0, rounding_ = 0.0; ///< mm
  std::optional<Eigen::Vector3d> direction_, view_point_;
  typename pcl::PointCloud<PointT>::ConstPtr obstacles_;
  bool quiet_ = false;
  ClosedView view_;
  ClosingReport figures_;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/cleaning/impl/ball_closing.hpp>

namespace pcl_spiral {
extern template class BallClosing<pcl::PointXYZ>;
extern template class BallClosing<pcl::PointXYZRGB>;
extern template class BallClosing<pcl::PointXYZI>;
extern template class BallClosing<pcl::PointNormal>;
} // namespace pcl_spiral
