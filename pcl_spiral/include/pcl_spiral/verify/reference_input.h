/** \file
 *  What the classes that judge a path have in common: the scan it is judged by.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/verify/cutter_path.h>
#include <pcl_spiral/verify/reference_surface.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

namespace pcl_spiral {

/** A surface, and where its points stand in the cloud it was made from. */
struct ScannedReference {
  ReferenceSurface surface;
  std::vector<std::uint32_t> source; ///< of the points given to surface.build, in the cloud
  /** Index in the cloud of point \p i of the surface's graph. */
  std::uint32_t cloudIndex(std::size_t i) const { return source[surface.source(i)]; }
};

/** Takes a reference (a cloud, or a surface already made of it) and a toolpath. Base of DeviationEstimation and
 *  MaterialRemoval. */
template <typename PointT>
class ReferenceInput : public pcl::PCLBase<PointT> {
public:
  using ToolpathConstPtr = pcl::PointCloud<ToolpathPoint>::ConstPtr;
  using NormalsConstPtr = pcl::PointCloud<pcl::Normal>::ConstPtr;

  /** The path to judge. Its points carry contact and normal; the axis is used where there is one. */
  void setInputToolpath(const ToolpathConstPtr& toolpath) { toolpath_ = toolpath; }
  ToolpathConstPtr getInputToolpath() const { return toolpath_; }

  /** Oriented normals of the reference, one a point, out of the material. Without them the side is found. */
  void setInputNormals(const NormalsConstPtr& normals) { normals_ = normals; }
  NormalsConstPtr getInputNormals() const { return normals_; }

  /** Where the scanner stood: the reference's normals face it. Without it they face +z as a whole. */
  void setViewPoint(const Eigen::Vector3d& point) { graph_options_.view_point = point; }
  const std::optional<Eigen::Vector3d>& getViewPoint() const { return graph_options_.view_point; }
  void clearViewPoint() { graph_options_.view_point.reset(); }

  /** Turn the reference's normals to the other side. */
  void setFlipNormals(bool flip) { graph_options_.flip_normals = flip; }
  bool getFlipNormals() const { return graph_options_.flip_normals; }

  /** Chord error asked of the path, mm, compared with the noise; 0.005 by default. */
  void setChordError(double error) { chord_error_ = error; }
  double getChordError() const { return chord_error_; }

  /** Threads to use; 0, the default, means all. The result does not depend on it. */
  void setNumberOfThreads(int threads) { thread_count_ = threads; }
  int getNumberOfThreads() const { return thread_count_; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Judge by a surface made before, from the same input cloud, indices, normals and side: saves making it twice.
   *  \see getReferenceSurface. A null pointer, the default: make it at every compute. */
  void setReferenceSurface(const std::shared_ptr<const ScannedReference>& surface) { given_surface_ = surface; }
  /** The surface of the last compute; null before. */
  std::shared_ptr<const ScannedReference> getReferenceSurface() const { return surface_; }

  const Status& getStatus() const { return status_; }

protected:
  /** Read the path and make the surface. */
  Status prepare(CutterPath& path);

  ToolpathConstPtr toolpath_;
  NormalsConstPtr normals_;
  SurfaceGraphOptions graph_options_;
  double chord_error_ = 0.005;
  int thread_count_ = 0;
  ProgressCallback progress_;
  std::shared_ptr<const ScannedReference> given_surface_, surface_;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/reference_input.hpp>
