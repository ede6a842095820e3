/** \file
 *  From a raw scan to the cloud every other stage works on.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/search/surface_graph.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Where the points of a scan went. input is the sum of the others. */
struct PreparationCounts {
  std::size_t input = 0;
  std::size_t nonfinite = 0; ///< NaN or infinite
  std::size_t duplicate = 0; ///< at the same place as an earlier point
  std::size_t outlier = 0;   ///< dropped by the statistical filter
  std::size_t thinned = 0;   ///< dropped by the voxel grid
  std::size_t used = 0;
};

/** Drops what is no surface point, thins if asked, puts the rest in spatial order and finds oriented normals.
 *
 *  Points that are not finite and exact repetitions are always dropped; statistical outliers and surplus
 * points when asked. Points are kept as they are, never moved, so that every one has an index in the input
 * (getSourceIndices). Normals are those of SurfaceGraph: PCA, out of the material, the side the cutter is on.
 * The input is never changed. The output does not depend on the number of threads. */
template <typename PointT>
class SurfacePreparation : public pcl::PCLBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<SurfacePreparation>;
  using ConstPtr = pcl::shared_ptr<const SurfacePreparation>;
  using PointCloud = pcl::PointCloud<PointT>;

  /** Fewest points a surface can be made of. */
  static constexpr std::size_t minimum_points = 50;

  /** Drop points whose mean distance to their \p neighbours nearest is more than \p deviations standard
   * deviations above the mean, as pcl::StatisticalOutlierRemoval. 0 neighbours, the default, is off. */
  void
  setOutlierRemoval(int neighbours, double deviations = 3.0)
  {
    outlier_neighbours_ = neighbours;
    outlier_deviations_ = deviations;
  }
  int
  getOutlierNeighbours() const
  {
    return outlier_neighbours_;
  }
  double
  getOutlierDeviations() const
  {
    return outlier_deviations_;
  }

  /** Keep one point of each voxel of this edge, mm: the one nearest to the voxel's centroid. 0, the default,
   * is off. */
  void
  setThinning(double voxel_edge)
  {
    thinning_ = voxel_edge;
  }
  double
  getThinning() const
  {
    return thinning_;
  }

  /** Where the scanner stood: normals face it. Without it they face +z as a whole. */
  void
  setViewPoint(const Eigen::Vector3d& point)
  {
    graph_options_.view_point = point;
  }
  const std::optional<Eigen::Vector3d>&
  getViewPoint() const
  {
    return graph_options_.view_point;
  }
  void
  clearViewPoint()
  {
    graph_options_.view_point.reset();
  }

  /** Turn all normals to the other side. */
  void
  setFlipNormals(bool flip)
  {
    graph_options_.flip_normals = flip;
  }
  bool
  getFlipNormals() const
  {
    return graph_options_.flip_normals;
  }

  /** Neighbours of a point to start with; 32 by default. */
  void
  setNumberOfNeighbours(int neighbours)
  {
    graph_options_.neighbours = neighbours;
  }
  int
  getNumberOfNeighbours() const
  {
    return graph_options_.neighbours;
  }

  /** Prepare the input (its indices, when set). \p cloud has the points kept, in spatial order; \p normals
   * one unit normal a point. Both are empty on failure: no cloud, a setting or index out of range, no finite
   * point, fewer than 50 points left, or no surface in them. */
  void compute(PointCloud& cloud, pcl::PointCloud<pcl::Normal>& normals);

  const Status&
  getStatus() const
  {
    return status_;
  }
  const PreparationCounts&
  getCounts() const
  {
    return counts_;
  }
  /** Index in the input of each output point. */
  const std::vector<std::uint32_t>&
  getSourceIndices() const
  {
    return source_indices_;
  }
  /** Order, normals, spacing and triangulation found on the way, for the stages that follow. */
  const SurfaceGraph&
  getSurfaceGraph() const
  {
    return graph_;
  }

private:
  Status check() const;
  Status select();

  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;

  int outlier_neighbours_ = 0;
  double outlier_deviations_ = 3.0;
  double thinning_ = 0.0;
  SurfaceGraphOptions graph_options_;
  Status status_;
  PreparationCounts counts_;
  std::vector<std::uint32_t> source_indices_;
  SurfaceGraph graph_;
};

} // namespace pcl_spiral

#include <pcl_spiral/surface/impl/surface_preparation.hpp>

namespace pcl_spiral {
extern template class SurfacePreparation<pcl::PointXYZ>;
extern template class SurfacePreparation<pcl::PointXYZRGB>;
extern template class SurfacePreparation<pcl::PointXYZI>;
extern template class SurfacePreparation<pcl::PointNormal>;
} // namespace pcl_spiral
