// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From two measured lines, or a scan with rough points, to rows of a beam or a cutter over a ridge.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/planning/impl/cloud_of.h>
#include <pcl_spiral/planning/impl/ridge_planning.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>

#include <utility>
#include <vector>

namespace pcl_spiral {

/** Plans rows over a ridge, as pcl_spiral_ridge does: both lines (measured, or found in a scan), rows (planRidgeRows), and with a cutter
 *  its locations on the scan, or on the ridge itself if there is no scan, with the checks of shank and holder. Lengths in mm.
 *  \code
 *  RidgePlanner<pcl::PointXYZ> planner;
 *  planner.setInputCloud(scan);
 *  planner.setRoughPoints({begin, between, end});
 *  planner.setHalfWidth(12.0);
 *  RidgeRowSettings rows;
 *  rows.step_over = 1.0;
 *  planner.setRowSettings(rows);
 *  PassSettings tool;
 *  tool.cutter = CutterShape::ball(6.0);
 *  planner.setPassSettings(tool);
 *  std::vector<ToolPoses> passes;
 *  planner.compute(passes);
 *  if (!planner.getStatus().ok()) ...    // and there are no passes
 *  \endcode
 *  The same input gives the same bytes for any number of threads. \sa RidgeToolpath, RidgeLines */
template <typename PointT>
class RidgePlanner : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  using Ptr = pcl::shared_ptr<RidgePlanner>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const RidgePlanner>; ///< A shared pointer to a constant one.

  RidgePlanner() { this->surfaceSettings().strict = false; } // a rough surface is accepted, with a warning

  /** Points measured along the ridge, and once across it, square to the rail; each in any order. */
  void setMeasuredLines(Polyline rail, Polyline generator)
  {
    asked_.rail = std::move(rail);
    asked_.generator = std::move(generator);
  }
  const Polyline& getRail() const { return asked_.rail; }           ///< The rail of setMeasuredLines.
  const Polyline& getGenerator() const { return asked_.generator; } ///< The generator of setMeasuredLines.

  /** In place of measured lines: places on the ridge in the scan, see RidgeLines::setRoughPoints. */
  void setRoughPoints(Polyline points) { asked_.rough_points = std::move(points); }
  const Polyline& getRoughPoints() const { return asked_.rough_points; } ///< The value of setRoughPoints.
  /** Whether the ridge in the scan is a ring; false by default. */
  void setClosed(bool closed) { asked_.closed = closed; }
  bool getClosed() const { return asked_.closed; } ///< The value of setClosed.
  /** How far the ridge in the scan extends to either side of its crest, mm. Must be set with rough points. */
  void setHalfWidth(double width) { asked_.half_width = width; }
  double getHalfWidth() const { return asked_.half_width; } ///< The value of setHalfWidth.

  void setRidgeSettings(const RidgeSettings& settings) { asked_.ridge = settings; } ///< Reference normal, side, measuring error.
  const RidgeSettings& getRidgeSettings() const { return asked_.ridge; }            ///< The value of setRidgeSettings.
  /** Distance, points and axes of the rows. Moves between cutter locations keep to PassSettings::tolerance; half of it is a usual chord
   *  error of the rows. */
  void setRowSettings(const RidgeRowSettings& settings) { asked_.rows = settings; }
  const RidgeRowSettings& getRowSettings() const { return asked_.rows; } ///< The value of setRowSettings.
  /** The tool; without a cutter it is a beam. Threads are those of setNumberOfThreads. */
  void setPassSettings(const PassSettings& settings) { asked_.tool = settings; }
  const PassSettings& getPassSettings() const { return asked_.tool; } ///< The value of setPassSettings.

  /** Points off the scanned surface are left out before all else, with a warning (OutlierRemoval); off by default. */
  void setLeaveOutStrays(bool leave_out) { asked_.leave_out_strays = leave_out; }
  bool getLeaveOutStrays() const { return asked_.leave_out_strays; } ///< The value of setLeaveOutStrays.
  /** Without a scan the plan has samples of the ridge, by which ProgramPlanner checks leads of a cutter; on by default. */
  void setSampleMesh(bool sample) { asked_.sample_mesh = sample; }
  bool getSampleMesh() const { return asked_.sample_mesh; } ///< The value of setSampleMesh.
  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { asked_.progress = std::move(callback); }

  /** Plans the rows. \p passes is empty on failure; see getStatus. */
  void compute(std::vector<ToolPoses>& passes)
  {
    compute();
    passes = plan_.passes;
  }

  /** The same; the passes are in getPlan alone. */
  void compute()
  {
    plan_ = RidgePlan();
    this->computeBy("RidgePlanner", [this] { return run(); });
  }

  const RidgePlan& getPlan() const { return plan_; } ///< The last plan.

private:
  Status run()
  {
    if (this->given_surface_)
      return {StatusCode::InvalidArgument, "{setInputSurface} was called, but the whole scan is needed, which tells what stands beside the "
                                           "ridge: give the {cloud} ({setInputCloud})"};
    if (this->givenIndices())
      return {StatusCode::InvalidArgument,
              "{setIndices} chooses a part of the scan, and what stands beside a ridge is all of it: leave the "
              "indices out"};
    if (const Status status = this->checkShared(); !status.ok())
      return status;
    if (this->input_)
      if (const Status status = this->scanned_.checkNormals(this->input_->size()); !status.ok())
        return status;
    const ThreadLimit limit(this->getNumberOfThreads());
    RidgePlanInput input = asked_;
    input.cloud = cloudOf<pcl::PointXYZ>(this->input_);
    input.normals = this->getInputNormals();
    input.surface = this->surfaceSettings();
    input.tool.threads = this->getNumberOfThreads();
    return planRidge(input, plan_);
  }

  RidgePlanInput asked_;
  RidgePlan plan_;
};

} // namespace pcl_spiral
