// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input shared by all stages that work on a surface.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/usable_points.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/console/print.h>

namespace pcl_spiral {

/** Takes a cloud, from which ScannedSurface makes the surface at every compute, or a Surface made before. The last one
 *  set counts: setInputCloud clears the surface.
 *
 *  Base of BoundaryLoops, GapBridging, GeodesicPath, RadialLines, StepOverField, MLSProjector, SpiralToolpathGenerator, CutterLocation,
 *  DrivePath and of the classes that check results. \p BaseT is the PCL class that each one replaces.
 *  setIndices: the surface is made of those points, as in ScannedSurface; with MLSProjector they are the queries, and all support it.
 */
template <typename BaseT, typename PointT, typename PointNT = pcl::Normal>
class SurfaceInput : public BaseT {
public:
  using CloudConstPtr = typename pcl::PointCloud<PointT>::ConstPtr;    ///< The input cloud, shared.
  using NormalsConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr; ///< Normals of the input, shared.

  /** The scan. Clears a surface given before. */
  void setInputCloud(const CloudConstPtr& cloud) override
  {
    BaseT::setInputCloud(cloud);
    given_surface_.reset();
  }

  /** Work on this surface, made by ScannedSurface or by another stage. The settings below that define a surface must be
   *  at their defaults, or as the surface was made. Normals must be null, because the surface already has a side. */
  virtual void setInputSurface(const Surface::ConstPtr& surface) { given_surface_ = surface; }
  Surface::ConstPtr getInputSurface() const { return given_surface_; } ///< The value of setInputSurface.

  /** Normals of the input cloud, one per point, out of the material. Only the side they face is used. Without them the view
   *  point gives the side, or else +z. \see ScannedSurface */
  void setInputNormals(const NormalsConstPtr& normals) { scanned_.setInputNormals(normals); }
  NormalsConstPtr getInputNormals() const { return scanned_.getInputNormals(); } ///< The value of setInputNormals.

  /** \see ScannedSurface::setTrustNormals */
  void setTrustNormals(bool trust) { surfaceSettings().trust_normals = trust; }
  bool getTrustNormals() const { return surfaceSettings().trust_normals; } ///< The value of setTrustNormals.

  /** \see ScannedSurface::setViewPoint */
  void setViewPoint(const Eigen::Vector3d& point) { surfaceSettings().view_point = point; }
  const std::optional<Eigen::Vector3d>& getViewPoint() const { return surfaceSettings().view_point; } ///< The value of setViewPoint.
  void clearViewPoint() { surfaceSettings().view_point.reset(); }                                     ///< Takes back setViewPoint.

  /** \see ScannedSurface::setHeightGrid */
  void setHeightGrid(const HeightGrid& grid) { surfaceSettings().heights = grid; }
  const std::optional<HeightGrid>& getHeightGrid() const { return surfaceSettings().heights; } ///< The value of setHeightGrid.
  void clearHeightGrid() { surfaceSettings().heights.reset(); }                                ///< Takes back setHeightGrid.

  /** Turn all normals to the other side. */
  void setFlipNormals(bool flip) { surfaceSettings().flip_normals = flip; }
  bool getFlipNormals() const { return surfaceSettings().flip_normals; } ///< The value of setFlipNormals.

  /** \see ScannedSurface::setThinning */
  void setThinning(double voxel_edge) { surfaceSettings().thinning = voxel_edge; }
  double getThinning() const { return surfaceSettings().thinning; } ///< The value of setThinning.

  /** \see ScannedSurface::setOutlierRemoval */
  void setOutlierRemoval(int neighbours, double deviations = 3.0)
  {
    surfaceSettings().outlier_neighbours = neighbours;
    surfaceSettings().outlier_deviations = deviations;
  }
  int getOutlierNeighbours() const { return surfaceSettings().outlier_neighbours; }    ///< The neighbours of setOutlierRemoval.
  double getOutlierDeviations() const { return surfaceSettings().outlier_deviations; } ///< The deviations of setOutlierRemoval.

  /** \see ScannedSurface::setLargestPart */
  void setLargestPart(bool alone) { surfaceSettings().largest_part = alone; }
  bool getLargestPart() const { return surfaceSettings().largest_part; } ///< The value of setLargestPart.

  /** \see ScannedSurface::setPartAt */
  void setPartAt(const Eigen::Vector3d& place) { surfaceSettings().part_at = place; }
  const std::optional<Eigen::Vector3d>& getPartAt() const { return surfaceSettings().part_at; } ///< The value of setPartAt.
  void clearPartAt() { surfaceSettings().part_at.reset(); }                                     ///< Takes back setPartAt.

  /** \see ScannedSurface::setClusterHandling */
  void setClusterHandling(ClusterHandling handling) { surfaceSettings().clusters = handling; }
  ClusterHandling getClusterHandling() const { return surfaceSettings().clusters; } ///< The value of setClusterHandling.

  /** Threads to use; 0, the default, means all. The output does not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { surfaceSettings().threads = threads; }
  unsigned int getNumberOfThreads() const { return surfaceSettings().threads; } ///< The value of setNumberOfThreads.

  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

  /** Result of the last compute. */
  const Status& getStatus() const { return status_; }

protected:
  /** Ok, or an error: neither surface nor cloud, a wrong number of normals, or what checkShared refuses. For stages that check
   *  their own settings before the surface is made. */
  Status checkInput() const
  {
    return given_surface_ ? checkShared()
                          : checkCloud("the input cloud is missing or empty: call {setInputCloud} with points, or "
                                       "{setInputSurface}");
  }

  /** The same for classes that take a whole scan, or a mesh in its place, but no surface. */
  Status checkScan() const
  {
    return checkCloud("the input cloud is missing or empty: call {setInputCloud} with points, or {setInputMesh}");
  }

  /** Ok, or an error: \p missing if there is no cloud, a wrong number of normals, or what checkShared refuses. */
  Status checkCloud(const char* missing) const
  {
    if (!this->input_ || this->input_->empty())
      return {StatusCode::InvalidInput, missing};
    const Status status = scanned_.checkNormals(this->input_->size());
    return status.ok() ? checkShared() : status;
  }

  /** Ok, or an error: an index outside the cloud, or a number of threads that nobody means. For any source of the surface. */
  Status checkShared() const
  {
    if (this->input_)
      if (const Status status = checkIndices(givenIndices().get(), this->input_->size()); !status.ok())
        return status;
    return checkThreads(getNumberOfThreads());
  }

  /** The given surface, or one made from the cloud. \p progress reports only the second case. */
  Status prepareSurface(Surface::ConstPtr& surface, const ProgressCallback& progress = {})
  {
    return prepareSurface(surface, progress, givenIndices());
  }

  /** The same, made from the points \p support of the cloud; null: from all. */
  Status prepareSurface(Surface::ConstPtr& surface, const ProgressCallback& progress, const pcl::IndicesPtr& support)
  {
    if (const Status status = checkInput(); !status.ok())
      return status;
    if (given_surface_) {
      if (scanned_.getInputNormals())
        return {StatusCode::InvalidArgument, "{setInputNormals} was called beside {setInputSurface}, whose surface has its side already: "
                                             "call {setInputNormals} with a null pointer, or give a cloud instead of a surface"};
      const Diagnostic setter = disagreement(surfaceSettings(), given_surface_->settings());
      surface = given_surface_;
      return setter.empty() ? Status::success()
                            : Status(StatusCode::InvalidArgument,
                                     Diagnostic(setter, " was called beside {setInputSurface}, and the surface was made otherwise: call "
                                                        "it on the {ScannedSurface}, or give a cloud instead of a surface"));
    }
    scanned_.setInputCloud(this->input_);
    scanned_.setIndices(support);
    scanned_.setSettings(surfaceSettings());
    scanned_.setProgressCallback(progress);
    scanned_.setQuiet(true);
    scanned_.compute(surface);
    return scanned_.getStatus();
  }

  /** Sets the status by \p run(); true if it is ok. Prints the error of the compute of \p name, unless it was cancelled. If an exception
   *  leaves \p run, the status is Status::unfinished. */
  template <typename Run>
  bool computeBy(const char* name, Run run)
  {
    status_ = Status::unfinished();
    status_ = run();
    if (!quiet_ && !status_.ok() && status_.code() != StatusCode::Cancelled)
      PCL_ERROR("[pcl_spiral::%s::compute] %s\n", name, status_.message().c_str());
    return status_.ok();
  }

  /** The settings of the surface. A class that has them among its own settings gives those, so that each has one owner. */
  virtual SurfaceSettings& surfaceSettings() { return surface_settings_; }
  /** \copydoc surfaceSettings */
  virtual const SurfaceSettings& surfaceSettings() const { return surface_settings_; }

  /** The indices of setIndices; null without them. */
  pcl::IndicesPtr givenIndices() const { return this->fake_indices_ ? nullptr : this->indices_; }

  ScannedSurface<PointT, PointNT> scanned_; ///< makes the surface; holds the normals
  Surface::ConstPtr given_surface_;         ///< of setInputSurface; null: the cloud counts
  bool quiet_ = false;                      ///< of setQuiet
  Status status_;                           ///< of the last compute

private:
  SurfaceSettings surface_settings_; ///< unless a class has its own
};

} // namespace pcl_spiral
