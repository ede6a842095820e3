// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the checks of a tool against a scan share: the scan, the tool, and false echoes.
 */
#pragma once

#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/verify/figures.h>

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>

#include <pcl/pcl_base.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** A tool against every point of a scan, also outliers: setInputCloud takes the scan, in the workpiece frame. Lengths in mm. */
template <typename PointT>
class ToolCheck : public pcl::PCLBase<PointT>, public ThreadCount {
public:
  /** Shape of the cutter. Must be set. */
  void setCutter(const CutterShape& cutter) { cutter_ = cutter; }
  const CutterShape& getCutter() const { return cutter_; } ///< The value of setCutter.

  /** The parts above the cutter, from the top of its flank upwards. None by default. */
  void setHolder(std::vector<ToolSegment> segments) { holder_ = std::move(segments); }
  const std::vector<ToolSegment>& getHolder() const { return holder_; } ///< The value of setHolder.

  /** Distance to keep between holder and scan; 0 by default. */
  void setHolderClearance(double clearance) { holder_clearance_ = clearance; }
  double getHolderClearance() const { return holder_clearance_; } ///< The value of setHolderClearance.

  /** How deep a point may be in the tool; 0.05 by default. Set what the path itself may have: its chord
   *  error plus five standard deviations of the noise of the scan, because the cutter touches the scan on it. */
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  double getTolerance() const { return tolerance_; } ///< The value of setTolerance.

  /** Outliers in groups of at most this many points count as false echoes, which are no obstacles: after a collision the check is
   *  repeated without them, see getObstacleReport. largest_echo suits scans. 0, the default: the check is not repeated. */
  void setLargestEcho(std::size_t points) { largest_echo_ = points; }
  std::size_t getLargestEcho() const { return largest_echo_; } ///< The value of setLargestEcho.

  /** Called with the completed share; return false to cancel. If the check is repeated, the share starts at 0 again. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

  const Status& getStatus() const { return status_; }      ///< Result of the last compute.
  const LeadReport& getReport() const { return figures_; } ///< Figures of the last compute, against every point.
  [[deprecated("use getReport")]] const LeadReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.
  /** Figures of the last compute without false echoes, if setLargestEcho was called: if no move collides here, all collisions of
   *  getReport are with echoes. The same as getReport if the scan has no echoes, or if its points form no surface. */
  const LeadReport& getObstacleReport() const { return obstacle_figures_; }
  [[deprecated("use getObstacleReport")]] const LeadReport& getObstacleFigures() const
  {
    return getObstacleReport();
  } ///< \deprecated Use getObstacleReport.

protected:
  /** Checks the cloud. */
  Status checkCloud() const;
  /** Checks the settings of the tool. */
  Status checkTool() const;
  HolderProfile holderProfile() const;
  const ProgressCallback& progress() const { return progress_; }

  /** Sets the figures by \p find(points, figures), and once more without false echoes after a collision. */
  template <typename Find>
  Status findAmongPoints(Find find);
  /** Sets status and figures by \p find(), with no figures on a failure; \p name of the class, for messages. */
  template <typename Find>
  void report(const char* name, Find find);

  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;
  LeadReport figures_, obstacle_figures_;

private:
  CutterShape cutter_;
  bool quiet_ = false;
  std::vector<ToolSegment> holder_;
  double holder_clearance_ = 0.0;
  double tolerance_ = 0.05;
  std::size_t largest_echo_ = 0;
  ProgressCallback progress_;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/tool_check.hpp>
