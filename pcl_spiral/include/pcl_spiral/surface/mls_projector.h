// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Projects points onto the surface of a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>
#include <pcl/surface/processing.h>

namespace pcl_spiral {

/** Feet, unit normals and principal curvatures of points on the moving-least-squares surface of a cloud.
 *
 *  Replaces pcl::MovingLeastSquares: through a pcl::CloudSurfaceProcessing pointer, setInputCloud and process give one foot
 *  per input point, or per index of setIndices; all points of the cloud support the surface. The output has the order of the queries.
 *  Of the setters of PCL, setSearchRadius and setPolynomialOrder work. setSearchMethod is refused, with a message.
 *
 *  Takes a cloud or a surface, see SurfaceInput. It fits the surface of MlsSurface: a local quadric, or the published
 *  directional centroid. Normals point out of the material. Curvatures are positive where the surface is convex, 1/mm.
 *
 *  PointOutT needs x y z. These fields are filled if present: normal_x y z; principal_curvature_x y z (direction of the larger
 *  curvature), pc1 (the larger), pc2; curvature (the mean of both, signed). Other fields that PointInT has, too, are copied from the
 *  query, header and sensor as well. A point without a foot becomes NaN: the output is then not dense. Order and threads do not count.
 */
template <typename PointInT, typename PointOutT>
class MLSProjector : public SurfaceInput<pcl::CloudSurfaceProcessing<PointInT, PointOutT>, PointInT> {
public:
  using Ptr = pcl::shared_ptr<MLSProjector>;                     ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const MLSProjector>;          ///< A shared pointer to a constant one.
  using PointCloudIn = pcl::PointCloud<PointInT>;                ///< A cloud of the input.
  using PointCloudInConstPtr = typename PointCloudIn::ConstPtr;  ///< The input, shared.
  using PointCloudOut = pcl::PointCloud<PointOutT>;              ///< The cloud of the output.
  using SearchPtr = typename pcl::search::Search<PointInT>::Ptr; ///< A search method of PCL.
  using Method = ProjectionMethod;                               ///< Type of the fitted surface.

  /** Points to project. Without them: the points of the input cloud that setIndices selects, or with a surface and no cloud,
   *  the points of the surface. */
  void setQueryCloud(const PointCloudInConstPtr& queries) { queries_ = queries; }
  PointCloudInConstPtr getQueryCloud() const { return queries_; } ///< The value of setQueryCloud.

  /** Type of the fitted surface; Method::Quadratic by default. */
  void setMethod(Method method) { method_ = method; }
  Method getMethod() const { return method_; } ///< The value of setMethod.

  /** Neighbours in one fit, 6 or more; 0, the default: the noise and the curvature decide. */
  void setKSearch(int neighbours) { neighbours_ = neighbours; }
  int getKSearch() const { return neighbours_; } ///< The value of setKSearch.
  /** The former name. */
  [[deprecated("setKSearch")]] void setNeighbours(int neighbours) { setKSearch(neighbours); }
  [[deprecated("getKSearch")]] int getNeighbours() const { return getKSearch(); } ///< The former name of getKSearch.

  /** Radius of one fit, mm, as in pcl::MovingLeastSquares: it takes pi (radius / spacing)^2 neighbours. 0, the default:
   *  setKSearch is used. Do not set both. */
  void setSearchRadius(double radius) { search_radius_ = radius; }
  double getSearchRadius() const { return search_radius_; } ///< The value of setSearchRadius.

  /** As in pcl::MovingLeastSquares: 2 is Method::Quadratic, 0 is Method::DirectionalCentroid; compute refuses others. */
  void setPolynomialOrder(int order);
  int getPolynomialOrder() const { return order_; } ///< The value of setPolynomialOrder.

  /** compute refuses a search that is not null: the projector uses its own exact search. */
  void setSearchMethod(const SearchPtr& search) { search_ = search; }
  SearchPtr getSearchMethod() const { return search_; } ///< The value of setSearchMethod.

  /** The name of compute in pcl::CloudSurfaceProcessing. */
  void process(PointCloudOut& output) override { compute(output); }

  /** Project every query. \p output has one point per query, in the same order. It is empty on failure: no cloud and no
   *  surface (see ScannedSurface), or a setting out of range. */
  void compute(PointCloudOut& output);

  /** For each query: 1 if it has a foot; 0 if it is not finite, farther than four spacings from the cloud, or beyond
   *  the rim of the cloud. */
  const std::vector<std::uint8_t>& getValid() const { return valid_; }
  /** Curvatures of each query, 1/mm, the larger in \p k1; NaN without a foot. */
  void getPrincipalCurvatures(std::vector<double>& k1, std::vector<double>& k2) const
  {
    k1 = larger_curvature_;
    k2 = smaller_curvature_;
  }
  /** Standard deviation of the cloud about the surface, mm. */
  double getNoise() const { return noise_; }
  /** Neighbours used in one fit by the last compute. */
  int getNeighboursUsed() const { return neighbours_used_; }

protected:
  void performProcessing(PointCloudOut& output) override { compute(output); } ///< What pcl::CloudSurfaceProcessing calls.

private:
  Status check() const;
  Status run(std::vector<SurfaceFoot>& feet);
  std::vector<Eigen::Vector3d> queryPoints(const Surface& surface) const;
  /** The cloud whose points are projected one by one; null if they are a selection from it, or points of the surface. */
  PointCloudInConstPtr wholeQueryCloud() const;
  void write(const std::vector<SurfaceFoot>& feet, PointCloudOut& output);

  PointCloudInConstPtr queries_;
  SearchPtr search_;
  Method method_ = Method::Quadratic;
  int neighbours_ = 0, order_ = 2;
  double search_radius_ = 0.0;
  std::vector<std::uint8_t> valid_;
  std::vector<double> larger_curvature_, smaller_curvature_;
  double noise_ = 0.0;
  int neighbours_used_ = 0;
};

} // namespace pcl_spiral

#include <pcl_spiral/surface/impl/mls_projector.hpp>

namespace pcl_spiral {
extern template class MLSProjector<pcl::PointXYZ, pcl::PointXYZ>;
extern template class MLSProjector<pcl::PointXYZ, pcl::PointNormal>;
extern template class MLSProjector<pcl::PointXYZRGB, pcl::PointXYZRGBNormal>;
extern template class MLSProjector<pcl::PointNormal, pcl::PointNormal>;
} // namespace pcl_spiral
