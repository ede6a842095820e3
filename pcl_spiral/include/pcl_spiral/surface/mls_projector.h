/** \file
 *  Points projected onto the surface behind a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/impl/mls_surface.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>
#include <pcl/surface/processing.h>

namespace pcl_spiral {

/** Feet, unit normals and principal curvatures of points on the moving-least-squares surface of a cloud.
 *
 *  Stands where pcl::MovingLeastSquares stands: through a pcl::CloudSurfaceProcessing pointer, setInputCloud and process give
 *  a foot for each point of the input. The output keeps the input's order, and a point without a foot comes out as NaN.
 *  Of PCL's setters setSearchRadius and setPolynomialOrder are taken over, and setSearchMethod is refused, with a message.
 *
 *  Takes a cloud or a surface, see SurfaceInput. The surface fitted is that of MlsSurface: a local quadric, or the published
 *  directional centroid. Normals point out of the material. Curvatures are positive where the surface is convex, 1/mm.
 *
 *  PointOutT needs x y z. Filled when it has them: normal_x y z; principal_curvature_x y z (the direction of the larger
 *  curvature), pc1 (the larger), pc2; curvature (the mean of both, signed). A point that has no foot comes out as NaN,
 *  and the output is then not dense. The output does not depend on the order of the cloud nor on the number of threads.
 */
template <typename PointInT, typename PointOutT>
class MLSProjector : public SurfaceInput<pcl::CloudSurfaceProcessing<PointInT, PointOutT>, PointInT> {
public:
  using Ptr = pcl::shared_ptr<MLSProjector>;
  using ConstPtr = pcl::shared_ptr<const MLSProjector>;
  using PointCloudIn = pcl::PointCloud<PointInT>;
  using PointCloudInConstPtr = typename PointCloudIn::ConstPtr;
  using PointCloudOut = pcl::PointCloud<PointOutT>;
  using SearchPtr = typename pcl::search::Search<PointInT>::Ptr;
  using Method = ProjectionMethod;

  /** Points to project; without it those of the input cloud, setIndices heeded, or with a surface and no cloud those of the
   *  surface. */
  void setQueryCloud(const PointCloudInConstPtr& queries) { queries_ = queries; }
  PointCloudInConstPtr getQueryCloud() const { return queries_; }

  /** The surface fitted; Method::Quadratic by default. */
  void setMethod(Method method) { method_ = method; }
  Method getMethod() const { return method_; }

  /** Neighbours in one fit, 6 or more; 0, the default: as many as the noise asks for and the curvature allows. */
  void setKSearch(int neighbours) { neighbours_ = neighbours; }
  int getKSearch() const { return neighbours_; }
  /** The former name. */
  [[deprecated("setKSearch")]] void setNeighbours(int neighbours) { setKSearch(neighbours); }
  [[deprecated("getKSearch")]] int getNeighbours() const { return getKSearch(); }

  /** As in pcl::MovingLeastSquares the radius of one fit, mm: it takes pi (radius / spacing)^2 neighbours. 0, the default:
   *  setKSearch counts. Not both. */
  void setSearchRadius(double radius) { search_radius_ = radius; }
  double getSearchRadius() const { return search_radius_; }

  /** As in pcl::MovingLeastSquares: 2 is Method::Quadratic, 0 Method::DirectionalCentroid; others are refused by compute. */
  void setPolynomialOrder(int order);
  int getPolynomialOrder() const { return order_; }

  /** Refused by compute where it is not null: neighbours are found by a search of the projector's own, exactly. */
  void setSearchMethod(const SearchPtr& search) { search_ = search; }
  SearchPtr getSearchMethod() const { return search_; }

  /** compute, as pcl::CloudSurfaceProcessing names it. */
  void process(PointCloudOut& output) override { compute(output); }

  /** Project every query. \p output has a point a query, in their order; it is empty on failure: no cloud and no
   *  surface (see ScannedSurface), or a setting out of range. */
  void compute(PointCloudOut& output);

  /** Of each query: 1 when it has a foot, 0 when it is not finite, farther than four spacings from the cloud, or beyond
   *  the cloud's rim. */
  const std::vector<std::uint8_t>& getValid() const { return valid_; }
  /** Curvatures of each query, 1/mm, the larger in \p k1; NaN where it has no foot. */
  void
  getPrincipalCurvatures(std::vector<double>& k1, std::vector<double>& k2) const
  {
    k1 = larger_curvature_;
    k2 = smaller_curvature_;
  }
  /** Standard deviation of the cloud about the surface, mm. */
  double getNoise() const { return noise_; }
  /** Neighbours taken in one fit by the last compute. */
  int getNeighboursUsed() const { return neighbours_used_; }

protected:
  void performProcessing(PointCloudOut& output) override { compute(output); }

private:
  Status check() const;
  Status run(std::vector<SurfaceFoot>& feet);
  std::vector<Eigen::Vector3d> queryPoints(const Surface& surface) const;
  /** The cloud whose points are projected one for one; null where they are a choice of it, or the surface's own. */
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
