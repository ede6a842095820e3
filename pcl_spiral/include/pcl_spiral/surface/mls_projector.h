/** \file
 *  Points projected onto the surface behind a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/mls_surface.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Feet, unit normals and principal curvatures of points on the moving-least-squares surface of a cloud.
 *
 *  The surface is that of MlsSurface: a local quadric, or the published directional centroid. Normals point out of the
 *  material: to the side of setInputNormals when given, else towards +z as a whole. Curvatures are positive where the
 *  surface is convex, 1/mm.
 *
 *  PointOutT needs x y z. Filled when it has them: normal_x y z; principal_curvature_x y z (the direction of the larger
 *  curvature), pc1 (the larger), pc2; curvature (the mean of both, signed). A point that has no foot comes out as NaN,
 *  and the output is then not dense. Non-finite points of the surface and exact repetitions are dropped. The output
 *  does not depend on the order of the cloud nor on the number of threads.
 */
template <typename PointInT, typename PointOutT>
class MLSProjector : public pcl::PCLBase<PointInT> {
public:
  using Ptr = pcl::shared_ptr<MLSProjector>;
  using ConstPtr = pcl::shared_ptr<const MLSProjector>;
  using PointCloudIn = pcl::PointCloud<PointInT>;
  using PointCloudInConstPtr = typename PointCloudIn::ConstPtr;
  using PointCloudOut = pcl::PointCloud<PointOutT>;
  using NormalsConstPtr = pcl::PointCloud<pcl::Normal>::ConstPtr;
  using Method = ProjectionMethod;

  /** Points to project; without it those of the surface itself, setIndices heeded. */
  void setQueryCloud(const PointCloudInConstPtr& queries) { queries_ = queries; }
  PointCloudInConstPtr getQueryCloud() const { return queries_; }

  /** One normal a point of the input cloud. They tell the side only, so at least nine in ten must agree on it. */
  void setInputNormals(const NormalsConstPtr& normals) { normals_ = normals; }
  NormalsConstPtr getInputNormals() const { return normals_; }

  /** The surface fitted; Method::Quadratic by default. */
  void setMethod(Method method) { method_ = method; }
  Method getMethod() const { return method_; }

  /** Neighbours in one fit, at least 6; 0, the default: as many as the noise asks for and the curvature allows. */
  void setNeighbours(int neighbours) { neighbours_ = neighbours; }
  int getNeighbours() const { return neighbours_; }

  /** Project every query. \p output has a point a query, in their order; it is empty on failure: no cloud, an index out
   *  of range, fewer than 50 different finite points, no surface in them, a setting out of range, or normals of another
   *  number or without a common side. */
  void compute(PointCloudOut& output);

  const Status& getStatus() const { return status_; }
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

private:
  Status check() const;
  std::vector<Eigen::Vector3d> queryPoints() const;
  Status findSide(const SurfaceGraph& graph, const std::vector<std::uint32_t>& source, bool& flip) const;
  void write(const std::vector<SurfaceFoot>& feet, bool flip, PointCloudOut& output);

  using pcl::PCLBase<PointInT>::input_;
  using pcl::PCLBase<PointInT>::indices_;

  PointCloudInConstPtr queries_;
  NormalsConstPtr normals_;
  Method method_ = Method::Quadratic;
  int neighbours_ = 0;
  Status status_;
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
