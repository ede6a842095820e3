// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input shared by the stages of a path at constant scallop height.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface_input.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl_spiral {

struct StepOverDistance;

/** Takes a cloud or a surface, see SurfaceInput, its loops, and the settings that define a step-over. Base of StepOverField. */
template <typename PointT, typename PointNT = pcl::Normal>
class StepOverInput : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  /** The rim (Outer) and holes (Inner) of the surface, as BoundaryLoops or GapBridging gives them, or the user's own. Distances count
   *  from all of them; gaps of the scan are crossed. None, the default: they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; } ///< The value of setBoundaryLoops.

  /** Radius of the ball cutter, mm. Must be set, above the scallop height. */
  void setToolRadius(double radius) { settings_.tool_radius = radius; }
  double getToolRadius() const { return settings_.tool_radius; } ///< The value of setToolRadius.

  /** Allowed height of the ridge between neighbouring loops, mm. Must be set. */
  void setScallopHeight(double height) { settings_.scallop_height = height; }
  double getScallopHeight() const { return settings_.scallop_height; } ///< The value of setScallopHeight.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Warnings of the last compute: a scan too coarse or with too much noise for the scallop height. */
  const Diagnostics& getWarnings() const { return warnings_; }

protected:
  SurfaceSettings& surfaceSettings() override { return settings_; }             ///< Its own.
  const SurfaceSettings& surfaceSettings() const override { return settings_; } ///< Its own.

  /** The given surface, or one made from the cloud, and the field between its loops. */
  Status makeField(Surface::ConstPtr& surface, std::shared_ptr<const StepOverDistance>& field, const ProgressCallback& progress);

  std::vector<BoundaryLoop> given_loops_; ///< of setBoundaryLoops
  SpiralSettings settings_;               ///< those that define a step-over, and those of the stage
  ProgressCallback progress_;             ///< of setProgressCallback
  Diagnostics warnings_;                  ///< of the last compute
};

/** Takes a field instead of a cloud or a surface. Base of ScallopLoops and LoopLinking. */
template <typename PointT, typename PointNT = pcl::Normal>
class FieldInput : public StepOverInput<PointT, PointNT> {
public:
  using FieldConstPtr = std::shared_ptr<const StepOverDistance>; ///< A field, shared.

  /** Work on this field, made by StepOverField, with the loops, radius and height it was made with; others are refused. Null, the
   *  default: it is made from the cloud or surface by the same rules. setInputCloud and setInputSurface clear it: call this after them. */
  void setInputField(const FieldConstPtr& field) { given_field_ = field; }
  FieldConstPtr getInputField() const { return given_field_; } ///< The value of setInputField.

  /** The scan. Clears a surface and a field. */
  void setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    StepOverInput<PointT, PointNT>::setInputCloud(cloud);
    given_field_.reset();
  }
  /** \see SurfaceInput::setInputSurface */
  void setInputSurface(const Surface::ConstPtr& surface) override
  {
    StepOverInput<PointT, PointNT>::setInputSurface(surface);
    given_field_.reset();
  }

protected:
  /** The given field, or one made, and then its \p surface too. */
  Status takeField(Surface::ConstPtr& surface, FieldConstPtr& field, const ProgressCallback& progress);

  FieldConstPtr given_field_; ///< of setInputField
};

} // namespace pcl_spiral
