/** \file
 *  What the classes that judge a path have in common: the scan it is judged by.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/verify/cutter_path.h>
#include <pcl_spiral/verify/reference_surface.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

namespace pcl_spiral {

/** Takes a reference (a cloud or a surface, see SurfaceInput) and a toolpath. Base of DeviationEstimation and MaterialRemoval.
 *
 *  The planner's own surface may be given (setInputSurface), which spares making one: its points are cleaned and oriented as
 *  the planner's, but the fit that judges is another one, see ReferenceSurface. */
template <typename PointT>
class ReferenceInput : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  using ToolpathConstPtr = pcl::PointCloud<ToolpathPoint>::ConstPtr;

  ReferenceInput() { this->scanned_.setStrict(false); } // a rough reference is judged by all the same, with a warning

  /** The path to judge. Its points carry contact and normal; the axis is used where there is one. */
  void setInputToolpath(const ToolpathConstPtr& toolpath) { toolpath_ = toolpath; }
  ToolpathConstPtr getInputToolpath() const { return toolpath_; }

  /** Chord error asked of the path, mm, compared with the noise; 0.005 by default. */
  void setChordError(double error) { chord_error_ = error; }
  double getChordError() const { return chord_error_; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Judge by a fit made before, of the same cloud or surface: saves making it twice. \see getReferenceSurface. A null
   *  pointer, the default: make it at every compute. setInputCloud and setInputSurface forget it. */
  void setReferenceSurface(const std::shared_ptr<const ReferenceSurface>& surface) { given_reference_ = surface; }
  /** The fit of the last compute; null before. */
  std::shared_ptr<const ReferenceSurface> getReferenceSurface() const { return reference_; }

  void
  setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputCloud(cloud);
    given_reference_.reset();
  }
  /** \see SurfaceInput::setInputSurface */
  void
  setInputSurface(const Surface::ConstPtr& surface)
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputSurface(surface);
    given_reference_.reset();
  }

protected:
  /** Read the path and make the surface. */
  Status prepare(CutterPath& path);

  ToolpathConstPtr toolpath_;
  double chord_error_ = 0.005;
  ProgressCallback progress_;
  std::shared_ptr<const ReferenceSurface> given_reference_, reference_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/reference_input.hpp>
