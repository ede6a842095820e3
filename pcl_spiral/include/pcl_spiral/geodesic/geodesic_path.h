// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shortest paths on a scanned surface, from a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/geodesic/geodesic_line.h>
#include <pcl_spiral/geodesic/impl/geodesic_path_engine.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <limits>
#include <vector>

namespace pcl_spiral {

/** Shortest paths on the surface behind a cloud, from one source to many targets.
 *
 *  Source and targets are positions on the surface, or points of the cloud. Each path has equal spacing and lies on the
 *  fitted surface, with its ends exactly at the given places. Lengths are those of a smooth curve. Millimetres.
 *  Source: Wu et al. 2025, equations 2-7, with the boundary conditions and the iteration of refineGeodesics.
 *  Takes a cloud or a surface, see SurfaceInput. Paths do not depend on the side; only the normals along them do. Indices of
 *  points need the cloud.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class GeodesicPath : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<GeodesicPath>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const GeodesicPath>; ///< A shared pointer to a constant one.
  using PointCloud = pcl::PointCloud<PointT>;           ///< The cloud of the input.

  /** Start of all paths. Must be set: a position, or an index into the input cloud. */
  void setSourcePoint(const Eigen::Vector3d& source) { source_ = {source, false, 0}; }
  void setSourceIndex(pcl::index_t index) { source_ = {Eigen::Vector3d::Zero(), true, index}; } ///< the same by index

  /** Ends of the paths, one path per target. Must be set: positions, or indices into the input cloud. */
  void setTargetPoints(const Polyline& targets);
  void setTargetIndices(const pcl::Indices& targets); ///< the same by indices

  /** Start of the refinement; the field by default. */
  void setStart(GeodesicStart start) { start_ = start; }
  GeodesicStart getStart() const { return start_; } ///< The value of setStart.

  /** How paths are refined; the tridiagonal Newton iteration by default. */
  void setMethod(RefinementMethod method) { options_.method = method; }
  RefinementMethod getMethod() const { return options_.method; } ///< The value of setMethod.

  /** Segments of a path, coarse to fine; 16, 32, 64, 128 by default. A path has one point more than the last. */
  void setLevels(const std::vector<int>& levels) { options_.levels = levels; }
  const std::vector<int>& getLevels() const { return options_.levels; } ///< The value of setLevels.

  /** Sideways move below which a path has converged, mm; 0.001 by default. */
  void setTolerance(double tolerance) { options_.tolerance = tolerance; }
  double getTolerance() const { return options_.tolerance; } ///< The value of setTolerance.

  /** Largest number of iterations per level; 30 by default. */
  void setMaximumIterations(int iterations) { options_.max_iterations = iterations; }
  int getMaximumIterations() const { return options_.max_iterations; } ///< The value of setMaximumIterations.

  /** Neighbours in one surface fit, 6 or more; 0, the default: as many as the noise needs. */
  void setKSearch(int neighbours) { fit_neighbours_ = neighbours; }
  int getKSearch() const { return fit_neighbours_; } ///< The value of setKSearch.
  /** The former name. */
  [[deprecated("setKSearch")]] void setFitNeighbours(int neighbours) { setKSearch(neighbours); }
  [[deprecated("getKSearch")]] int getFitNeighbours() const { return getKSearch(); } ///< The former name of getKSearch.

  /** Find the paths, in the order of the targets. On failure (see getStatus) the paths that were not found are empty, or all. */
  void compute(std::vector<PointCloud>& paths);
  void compute(std::vector<Polyline>& paths); ///< The same in double precision.

  /** Length of each path of the last compute, mm; NaN for a path that was not found. */
  const std::vector<double>& getLengths() const { return lengths_; }
  /** The paths with normals and curvatures, as refined; a path that left the surface is included up to that place. */
  const std::vector<GeodesicLine>& getLines() const { return lines_; }

private:
  /** A position, or the point of the cloud at an index. */
  struct GivenPlace {
    Eigen::Vector3d position = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    bool by_index = false;
    pcl::index_t index = 0;
  };
  Status check() const;
  Status checkPlace(const GivenPlace& place, const Diagnostic& name) const;
  Eigen::Vector3d positionOf(const GivenPlace& place) const;
  Status run();

  using pcl::PCLBase<PointT>::input_;
  GivenPlace source_;
  std::vector<GivenPlace> targets_;
  GeodesicStart start_ = GeodesicStart::Field;
  RefinementOptions options_;
  int fit_neighbours_ = 0;
  std::vector<GeodesicLine> lines_;
  std::vector<double> lengths_;
};

} // namespace pcl_spiral

#include <pcl_spiral/geodesic/impl/geodesic_path.hpp>

namespace pcl_spiral {
extern template class GeodesicPath<pcl::PointXYZ>;
extern template class GeodesicPath<pcl::PointXYZRGB>;
extern template class GeodesicPath<pcl::PointNormal>;
} // namespace pcl_spiral
