// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a raw scan to the points and normals of its surface, as a filter.
 */
#pragma once

#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/filters/filter.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** \deprecated Use SurfaceReport. */
using PreparationCounts [[deprecated("use SurfaceReport")]] = SurfaceReport;

/** ScannedSurface as a pcl::Filter. It leaves out points that are not part of the surface, thins on request, puts the rest in
 *  spatial order, and finds oriented normals.
 *
 *  Points are never moved, so each output point has an index in the input (getSourceIndices). getRemovedIndices has the points
 *  left out if the constructor got true. The output does not depend on the number of threads.
 *  \code
 *  SurfacePreparation<pcl::PointXYZ> preparation;
 *  preparation.setInputCloud(scan);
 *  preparation.filter(*clean);              // or compute(*clean, *normals)
 *  if (!preparation.getStatus().ok()) ...   // and the output is empty; see filter
 *  \endcode
 */
template <typename PointT>
class SurfacePreparation : public pcl::Filter<PointT> {
public:
  using Ptr = pcl::shared_ptr<SurfacePreparation>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const SurfacePreparation>; ///< A shared pointer to a constant one.
  using PointCloud = pcl::PointCloud<PointT>;                 ///< The cloud of the input.

  /** \p extract_removed_indices: if true, getRemovedIndices has the points left out. */
  explicit SurfacePreparation(bool extract_removed_indices = false) : pcl::Filter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "SurfacePreparation";
  }

  /** Clears the last result. A null pointer is an error at once. */
  void setInputCloud(const typename PointCloud::ConstPtr& cloud) override
  {
    pcl::Filter<PointT>::setInputCloud(cloud);
    forget();
    if (!cloud)
      status_ = missingCloud();
  }

  /** As in pcl::Filter, but the output is also empty if there is no cloud. Through a pointer to pcl::Filter, pcl::Filter::filter
   *  leaves the output unchanged in that case and does not call this filter. */
  void filter(PointCloud& output);

  /** \see ScannedSurface::setOutlierRemoval */
  void setOutlierRemoval(int neighbours, double deviations = 3.0) { scanned_.setOutlierRemoval(neighbours, deviations); }
  int getOutlierNeighbours() const { return scanned_.getOutlierNeighbours(); }    ///< The neighbours of setOutlierRemoval.
  double getOutlierDeviations() const { return scanned_.getOutlierDeviations(); } ///< The deviations of setOutlierRemoval.

  /** \see ScannedSurface::setThinning */
  void setThinning(double voxel_edge) { scanned_.setThinning(voxel_edge); }
  double getThinning() const { return scanned_.getThinning(); } ///< The value of setThinning.

  /** \see ScannedSurface::setLargestPart */
  void setLargestPart(bool alone) { scanned_.setLargestPart(alone); }
  bool getLargestPart() const { return scanned_.getLargestPart(); } ///< The value of setLargestPart.

  /** \see ScannedSurface::setPartAt */
  void setPartAt(const Eigen::Vector3d& place) { scanned_.setPartAt(place); }
  const std::optional<Eigen::Vector3d>& getPartAt() const { return scanned_.getPartAt(); } ///< The value of setPartAt.
  void clearPartAt() { scanned_.clearPartAt(); }                                           ///< Takes back setPartAt.

  /** \see ScannedSurface::setClusterHandling */
  void setClusterHandling(ClusterHandling handling) { scanned_.setClusterHandling(handling); }
  ClusterHandling getClusterHandling() const { return scanned_.getClusterHandling(); } ///< The value of setClusterHandling.

  /** \see ScannedSurface::setViewPoint */
  void setViewPoint(const Eigen::Vector3d& point) { scanned_.setViewPoint(point); }
  const std::optional<Eigen::Vector3d>& getViewPoint() const { return scanned_.getViewPoint(); } ///< The value of setViewPoint.
  void clearViewPoint() { scanned_.clearViewPoint(); }                                           ///< Takes back setViewPoint.

  /** \see ScannedSurface::setFlipNormals */
  void setFlipNormals(bool flip) { scanned_.setFlipNormals(flip); }
  bool getFlipNormals() const { return scanned_.getFlipNormals(); } ///< The value of setFlipNormals.

  /** \see ScannedSurface::setKSearch */
  void setKSearch(int neighbours) { scanned_.setKSearch(neighbours); }
  int getKSearch() const { return scanned_.getKSearch(); } ///< The value of setKSearch.
  /** The former name. */
  [[deprecated("setKSearch")]] void setNumberOfNeighbours(int neighbours) { setKSearch(neighbours); }
  [[deprecated("getKSearch")]] int getNumberOfNeighbours() const { return getKSearch(); } ///< The former name of getKSearch.

  /** \see ScannedSurface::setStrict */
  void setStrict(bool strict) { scanned_.setStrict(strict); }
  bool getStrict() const { return scanned_.getStrict(); } ///< The value of setStrict.

  /** Threads to use; 0, the default, means all. */
  void setNumberOfThreads(unsigned int threads = 0) { scanned_.setNumberOfThreads(threads); }
  unsigned int getNumberOfThreads() const { return scanned_.getNumberOfThreads(); } ///< The value of setNumberOfThreads.

  /** filter, with one unit normal per point: \p cloud has the points kept, in spatial order. Both are empty on failure,
   *  see ScannedSurface::compute. */
  void compute(PointCloud& cloud, pcl::PointCloud<pcl::Normal>& normals);

  const Status& getStatus() const { return status_; }        ///< result of the last run
  const SurfaceReport& getReport() const { return counts_; } ///< What happened to the points in the last run.
  [[deprecated("use getReport")]] const SurfaceReport& getCounts() const { return getReport(); } ///< \deprecated Use getReport.
  /** Index in the input of each output point. */
  const pcl::Indices& getSourceIndices() const { return source_indices_; }
  /** The surface of the last run, for the stages that follow (setInputSurface); null before a run and on failure. */
  Surface::ConstPtr getSurface() const { return surface_; }
  /** The former name of getSurface()->graph(); empty before the first run and on failure. */
  [[deprecated("getSurface()->graph()")]] const SurfaceGraph& getSurfaceGraph() const
  {
    static const SurfaceGraph none;
    return surface_ ? surface_->graph() : none;
  }

protected:
  void applyFilter(PointCloud& output) override; ///< What pcl::Filter calls.

private:
  static Status missingCloud() { return {StatusCode::InvalidInput, "the input cloud is missing: call {setInputCloud} with points"}; }
  void forget();

  ScannedSurface<PointT> scanned_;
  Surface::ConstPtr surface_;
  Status status_;
  SurfaceReport counts_;
  pcl::Indices source_indices_;
};

} // namespace pcl_spiral

#include <pcl_spiral/surface/impl/surface_preparation.hpp>

namespace pcl_spiral {
extern template class SurfacePreparation<pcl::PointXYZ>;
extern template class SurfacePreparation<pcl::PointXYZRGB>;
extern template class SurfacePreparation<pcl::PointXYZI>;
extern template class SurfacePreparation<pcl::PointNormal>;
} // namespace pcl_spiral
