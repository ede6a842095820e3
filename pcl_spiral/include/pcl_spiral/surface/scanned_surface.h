// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan to the surface that every stage uses.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/surface/surface.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

struct UsablePoints;

/** Cleans, orients and thins a scan, and can keep only its largest part. All stages use this class for these tasks.
 *
 *  Always left out: points that are not finite, exact duplicates, isolated points off the surface, clusters apart from
 *  it, and the surplus where points lie much closer in one direction than in the other. Left out on request: statistical
 *  outliers and thinned points. Points are never moved. PCA finds the normals. They point out of the material, to the side of
 *  the cutter: the side the input normals face as a whole, else the view point, else +z, else the convex side (with a warning). Input
 *  normals on a hollow side away from +z are warned of, unless a view point confirms them: pcl::NormalEstimation turns to (0, 0, 0).
 *
 *  setIndices: only those points take part. The others are not used and do not count as left out. Stages that get a cloud make
 *  the same surface by the same rules. To save time, make it once and give it to all stages (setInputSurface).
 *  The result does not depend on the order of the cloud or on the number of threads. Lengths in mm.
 *  \code
 *  pcl_spiral::ScannedSurface<pcl::PointXYZ> scanned;
 *  scanned.setInputCloud(scan);
 *  pcl_spiral::Surface::ConstPtr surface;
 *  scanned.compute(surface); // null on failure: scanned.getStatus() says why
 *  \endcode
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ScannedSurface : public pcl::PCLBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<ScannedSurface>;                         ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const ScannedSurface>;              ///< A shared pointer to a constant one.
  using NormalsConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr; ///< Normals of the input, shared.

  /** Normals of the input, one per point, out of the material. Only the side they face is used. Null, the default: none. */
  void setInputNormals(const NormalsConstPtr& normals) { normals_ = normals; }
  NormalsConstPtr getInputNormals() const { return normals_; } ///< The value of setInputNormals.

  /** Refuse input normals without a common side (more than a tenth disagree); true by default. If false, such normals are not
   *  used, with a warning: the view point or +z decides. */
  void setTrustNormals(bool trust) { settings_.trust_normals = trust; }
  bool getTrustNormals() const { return settings_.trust_normals; } ///< The value of setTrustNormals.

  /** Position of the scanner: normals face it. Without it, that of the cloud counts if it is not zero (pcl::PointCloud::sensor_origin_,
   *  VIEWPOINT of a file), with a warning if it is on the other side than +z; else normals face +z as a whole. */
  void setViewPoint(const Eigen::Vector3d& point) { settings_.view_point = point; }
  const std::optional<Eigen::Vector3d>& getViewPoint() const { return settings_.view_point; } ///< The value of setViewPoint.
  void clearViewPoint() { settings_.view_point.reset(); }                                     ///< Takes back setViewPoint.

  /** Turn all normals to the other side. */
  void setFlipNormals(bool flip) { settings_.flip_normals = flip; }
  bool getFlipNormals() const { return settings_.flip_normals; } ///< The value of setFlipNormals.

  /** The points are nodes of this grid, as BallClosing makes them: the grid defines triangles and side, and no point is an outlier. Without
   *  it, the default, all of that is found from the points. */
  void setHeightGrid(const HeightGrid& grid) { settings_.heights = grid; }
  const std::optional<HeightGrid>& getHeightGrid() const { return settings_.heights; } ///< The value of setHeightGrid.
  void clearHeightGrid() { settings_.heights.reset(); }                                ///< Takes back setHeightGrid.

  /** Keep only the part with the largest area if there are several. Without it, the default, all stay, and stages that
   *  need a single part refuse the surface. Clusters are left out in both cases. */
  void setLargestPart(bool alone) { settings_.largest_part = alone; }
  bool getLargestPart() const { return settings_.largest_part; } ///< The value of setLargestPart.

  /** Of several separate parts keep the one nearest to \p place. Fails if no point of the surface is within ten spacings of it. Comes
   *  before setLargestPart. */
  void setPartAt(const Eigen::Vector3d& place) { settings_.part_at = place; }
  const std::optional<Eigen::Vector3d>& getPartAt() const { return settings_.part_at; } ///< The value of setPartAt.
  void clearPartAt() { settings_.part_at.reset(); }                                     ///< Takes back setPartAt.

  /** What to do with two or more points near each other that stand off the surface by more than its noise (Surface::clusters). Single
   *  ones are left out. ClusterHandling::Refuse by default; unless strict that only warns. */
  void setClusterHandling(ClusterHandling handling) { settings_.clusters = handling; }
  ClusterHandling getClusterHandling() const { return settings_.clusters; } ///< The value of setClusterHandling.

  /** Keep one point in each voxel of this edge length, the one nearest to the centroid of the voxel; 0, the default: all. */
  void setThinning(double voxel_edge) { settings_.thinning = voxel_edge; }
  double getThinning() const { return settings_.thinning; } ///< The value of setThinning.

  /** Drop points whose mean distance to their \p neighbours nearest points is more than \p deviations standard deviations above
   *  the mean, as in pcl::StatisticalOutlierRemoval. 0 neighbours, the default: no filter. */
  void setOutlierRemoval(int neighbours, double deviations = 3.0)
  {
    settings_.outlier_neighbours = neighbours;
    settings_.outlier_deviations = deviations;
  }
  int getOutlierNeighbours() const { return settings_.outlier_neighbours; }    ///< The neighbours of setOutlierRemoval.
  double getOutlierDeviations() const { return settings_.outlier_deviations; } ///< The deviations of setOutlierRemoval.

  /** Neighbours of a point to start with, 8 or more; 32 by default. Doubled while scan lines are too far apart. */
  void setKSearch(int neighbours) { settings_.neighbours = neighbours; }
  int getKSearch() const { return settings_.neighbours; } ///< The value of setKSearch.

  /** Radius of the largest circle without points that still counts as surface, in spacings, 1 or more; 3 by default. */
  void setAlpha(double spacings) { settings_.alpha = spacings; }
  double getAlpha() const { return settings_.alpha; } ///< The value of setAlpha.

  /** Refuse a scan that is no single sheet (noise above 0.35 spacings), is badly connected (more than a tenth of the points
   *  isolated), or has normals without a common side (more than a tenth disagree); true by
   *  default. */
  void setStrict(bool strict) { settings_.strict = strict; }
  bool getStrict() const { return settings_.strict; } ///< The value of setStrict.

  /** Threads to use; 0, the default, means all. The output does not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { settings_.threads = threads; }
  unsigned int getNumberOfThreads() const { return settings_.threads; } ///< The value of setNumberOfThreads.

  /** Set all of the above at once, but for the normals. */
  void setSettings(const SurfaceSettings& settings) { settings_ = settings; }
  const SurfaceSettings& getSettings() const { return settings_; } ///< The value of setSettings.

  /** If true, compute prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Make the surface. \p surface is null on failure: no cloud, no finite point, a setting or index out of range, a wrong
   *  number of normals, fewer than 50 points left, no surface in them, no single sheet, or cancelled. */
  void compute(Surface::ConstPtr& surface);

  const Status& getStatus() const { return status_; } ///< result of the last run

  /** Ok, or an error if the input normals are not one per point of a cloud of \p size points. */
  Status checkNormals(std::size_t size) const;

private:
  Status check() const;
  SurfaceSettings sidedSettings() const;
  Status filter(UsablePoints& usable, SurfaceReport& counts, std::vector<std::uint32_t>& dropped, std::vector<LeftOut>& why) const;
  Status run(Surface::ConstPtr& surface);
  Status checkSide(const Surface& surface) const;
  void addLeftOut(const std::vector<std::uint32_t>& indices, const std::vector<LeftOut>& why, LeftOutPoints& points) const;
  const pcl::Indices* givenIndices() const { return this->fake_indices_ ? nullptr : this->indices_.get(); }

  NormalsConstPtr normals_;
  SurfaceSettings settings_;
  bool quiet_ = false;
  ProgressCallback progress_;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/surface/impl/scanned_surface.hpp>

namespace pcl_spiral {
extern template class ScannedSurface<pcl::PointXYZ>;
extern template class ScannedSurface<pcl::PointXYZRGB>;
extern template class ScannedSurface<pcl::PointXYZI>;
extern template class ScannedSurface<pcl::PointNormal>;
} // namespace pcl_spiral
