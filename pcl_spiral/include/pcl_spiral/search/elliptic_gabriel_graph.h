// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Neighbour graph of a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/search/impl/gabriel_edges.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Elliptic Gabriel graph of a cloud: symmetric neighbour lists that follow the surface.
 *
 *  Source: Park, Shin, Choi, Elliptic Gabriel graph for finding neighbors in a point set and its application
 * to normal vector estimation, Computer-Aided Design 38(6), 2006. The test and its exactness:
 * ellipticGabrielEdges. On a plane of random points the mean degree is 4 / alpha. With setIndices only those
 * points take part. Points that are not finite have no neighbours. */
template <typename PointT, typename PointNT = pcl::Normal>
class EllipticGabrielGraph : public pcl::PCLBase<PointT> {
public:
  using Ptr = pcl::shared_ptr<EllipticGabrielGraph>;                   ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const EllipticGabrielGraph>;        ///< A shared pointer to a constant one.
  using NormalsConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr; ///< Normals of the input, shared.

  /** Axis of the ellipsoid across an edge divided by the axis along it, in (0, sqrt 2]; 0.75 by default, 1 is the
   * Gabriel graph. A smaller value joins more points. */
  void setAlpha(double alpha) { options_.alpha = alpha; }
  double getAlpha() const { return options_.alpha; } ///< The value of setAlpha.

  /** Nearest neighbours tested for each point; 32 by default. */
  void setKSearch(int k) { options_.candidates = k; }
  int getKSearch() const { return options_.candidates; } ///< The value of setKSearch.
  /** The former name. */
  [[deprecated("setKSearch")]] void setNumberOfCandidates(int k) { setKSearch(k); }
  [[deprecated("getKSearch")]] int getNumberOfCandidates() const { return getKSearch(); } ///< The former name of getKSearch.

  /** Longest edge in local spacings; 3.5 by default, 0 for any length. It keeps the graph from bridging holes. */
  void setMaxEdgeLength(double spacings) { options_.max_edge = spacings; }
  double getMaxEdgeLength() const { return options_.max_edge; } ///< The value of setMaxEdgeLength.

  /** Oriented unit normals, one per point of the input cloud; used only with setMaxNormalAngle. */
  void setInputNormals(const NormalsConstPtr& normals) { normals_ = normals; }
  NormalsConstPtr getInputNormals() const { return normals_; } ///< The value of setInputNormals.

  /** Largest angle between the normals of an edge's ends, degrees, up to 180; 0, the default, means no limit. It
   * keeps the two sides of a thin wall apart. */
  void setMaxNormalAngle(double degrees) { max_normal_angle_ = degrees; }
  double getMaxNormalAngle() const { return max_normal_angle_; } ///< The value of setMaxNormalAngle.

  /** Threads to use; 0, the default, means all. The output does not depend on it. */
  void setNumberOfThreads(unsigned int threads = 0) { options_.threads = threads; }
  unsigned int getNumberOfThreads() const { return options_.threads; } ///< The value of setNumberOfThreads.

  /** Find the neighbours of every point of the input cloud. \p graph is empty on failure: no cloud, no finite
   * point, an index or setting out of range, normals missing or their number wrong. */
  void compute(NeighbourLists& graph);

  const Status& getStatus() const { return status_; } ///< Result of the last compute.

private:
  Status check() const;
  std::vector<std::uint32_t> usablePoints() const;

  using pcl::PCLBase<PointT>::input_;
  using pcl::PCLBase<PointT>::indices_;

  NormalsConstPtr normals_;
  GabrielOptions options_;
  double max_normal_angle_ = 0.0;
  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/search/impl/elliptic_gabriel_graph.hpp>

namespace pcl_spiral {
extern template class EllipticGabrielGraph<pcl::PointXYZ>;
extern template class EllipticGabrielGraph<pcl::PointXYZRGB>;
extern template class EllipticGabrielGraph<pcl::PointNormal>;
} // namespace pcl_spiral
