/** \file
 *  What the stages of a path at constant scallop height have in common.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {

struct StepOverDistance;

/** Takes a cloud or a surface, see SurfaceInput, its loops, and what a step-over is measured by. Base of StepOverField. */
template <typename PointT, typename PointNT = pcl::Normal>
class StepOverInput : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  /** Rims (Outer) and holes (Inner) of the surface, as BoundaryLoops or GapBridging give them, or a user's own: distances are
   *  counted from all of them, and gaps of the scan are passed over. None, the default: they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; }

  /** Radius of the ball cutter, mm. Must be set, above the scallop height. */
  void setToolRadius(double radius) { settings_.tool_radius = radius; }
  double getToolRadius() const { return settings_.tool_radius; }

  /** Allowed height of the ridge between neighbouring loops, mm. Must be set. */
  void setScallopHeight(double height) { settings_.scallop_height = height; }
  double getScallopHeight() const { return settings_.scallop_height; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Of the last compute: a scan too coarse or too rough for the scallop height. */
  const std::vector<std::string>& getWarnings() const { return warnings_; }

protected:
  /** The surface given, or one made of the cloud, and the field between its loops. */
  Status makeField(Surface::ConstPtr& surface, std::shared_ptr<const StepOverDistance>& field, const ProgressCallback& progress);

  std::vector<BoundaryLoop> given_loops_;
  SpiralSettings settings_;
  ProgressCallback progress_;
  std::vector<std::string> warnings_;
};

/** Takes a field in place of a cloud or a surface. Base of ScallopLoops and LoopLinking. */
template <typename PointT, typename PointNT = pcl::Normal>
class FieldInput : public StepOverInput<PointT, PointNT> {
public:
  using FieldConstPtr = std::shared_ptr<const StepOverDistance>;

  /** Work on this field, made by StepOverField: loops, radius and height that it was made with count. Null, the default: it is
   *  made of the cloud or surface by the same rules. Both setInputCloud and setInputSurface forget it: call this after them. */
  void setInputField(const FieldConstPtr& field) { given_field_ = field; }
  FieldConstPtr getInputField() const { return given_field_; }

  void
  setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    StepOverInput<PointT, PointNT>::setInputCloud(cloud);
    given_field_.reset();
  }
  /** \see SurfaceInput::setInputSurface */
  void
  setInputSurface(const Surface::ConstPtr& surface)
  {
    StepOverInput<PointT, PointNT>::setInputSurface(surface);
    given_field_.reset();
  }

protected:
  /** The field given, or one made, and then its \p surface too. */
  Status takeField(Surface::ConstPtr& surface, FieldConstPtr& field, const ProgressCallback& progress);

  FieldConstPtr given_field_;
};

} // namespace pcl_spiral
