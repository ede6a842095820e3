// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks whether a tool comes to its path and leaves it without cutting into the scan.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/false_echoes.h>
#include <pcl_spiral/verify/impl/lead_check_engine.h>

#include <pcl/pcl_base.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Checks what a program does apart from cutting: approaches, leads, retracts, turns at the top.
 *  To check the path itself, use CutterLocation, or DeviationEstimation and MaterialRemoval.
 *
 *  setInputCloud takes the scan, in the workpiece frame of the program. Every point counts,
 *  also outliers, so add whatever else stands on the table. With setLargestEcho the check
 *  also tells false echoes from the part and from clamps. Lengths in mm. The result does
 *  not depend on the order of the points or on the number of threads.
 *  \code
 *  LeadCheck<pcl::PointXYZ> check;
 *  check.setInputCloud(scan);
 *  check.setCutter(CutterShape::ball(5.0));
 *  check.compute(program);
 *  if (!check.getStatus().ok()) ...            // could not be looked at
 *  if (check.getFigures().collided > 0) ...    // check.getFigures().deepest says where
 *  \endcode */
template <typename PointT>
class LeadCheck : public pcl::PCLBase<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<LeadCheck>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const LeadCheck>; ///< A shared pointer to a constant one.

  /** Shape of the cutter. Must be set. Above it, a shank as wide as the cutter is assumed. */
  void setCutter(const CutterShape& cutter) { cutter_ = cutter; }
  const CutterShape& getCutter() const { return cutter_; } ///< The value of setCutter.

  /** The parts above the cutter, from the top of its flank upwards. None by default. */
  void setHolder(std::vector<ToolSegment> segments) { holder_ = std::move(segments); }
  const std::vector<ToolSegment>& getHolder() const { return holder_; } ///< The value of setHolder.

  /** Distance to keep between holder and scan; 0 by default. */
  void setHolderClearance(double clearance) { holder_clearance_ = clearance; }
  double getHolderClearance() const { return holder_clearance_; } ///< The value of setHolderClearance.

  /** How deep a point may be in the tool; 0.05 by default. Set what the path itself may have: its chord
   *  error plus five standard deviations of the noise of the scan, because leads end on the path. */
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  double getTolerance() const { return tolerance_; } ///< The value of setTolerance.

  /** Outliers in groups of at most this many points count as false echoes, which are no obstacles: after a collision the check is
   *  repeated without them, see getObstacleFigures. largest_echo suits scans. 0, the default: the check is not repeated. */
  void setLargestEcho(std::size_t points) { largest_echo_ = points; }
  std::size_t getLargestEcho() const { return largest_echo_; } ///< The value of setLargestEcho.

  /** Called with the completed share; return false to cancel. If the check is repeated, the share starts at 0 again. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Checks \p program. Fails without a cloud or a cutter, on invalid settings, or when cancelled. */
  void compute(const MachineProgram& program);

  const Status& getStatus() const { return status_; }        ///< Result of the last compute.
  const LeadFigures& getFigures() const { return figures_; } ///< Figures of the last compute, against every point.
  /** Figures of the last compute without false echoes, if setLargestEcho was called: if no move collides here, all collisions of
   *  getFigures are with echoes. The same as getFigures if the scan has no echoes, or if its points form no surface. */
  const LeadFigures& getObstacleFigures() const { return obstacle_figures_; }

private:
  Status check() const;
  Status findCollisions(const MachineProgram& program);

  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;

  CutterShape cutter_;
  std::vector<ToolSegment> holder_;
  double holder_clearance_ = 0.0;
  double tolerance_ = 0.05;
  std::size_t largest_echo_ = 0;
  ProgressCallback progress_;
  Status status_;
  LeadFigures figures_, obstacle_figures_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/lead_check.hpp>

namespace pcl_spiral {
extern template class LeadCheck<pcl::PointXYZ>;
extern template class LeadCheck<pcl::PointXYZRGB>;
extern template class LeadCheck<pcl::PointNormal>;
} // namespace pcl_spiral
