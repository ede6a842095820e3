#pragma once

#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/surface/mls_projector.h>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled
#include <pcl/type_traits.h>

#include <algorithm>
#include <limits>
#include <string>

namespace pcl_spiral {
namespace detail {

/** Set what \p point has of a foot's position, normal and curvatures. */
template <typename PointT>
void
setFoot(PointT& point, const SurfaceFoot& foot)
{
  point.getVector3fMap() = foot.position.template cast<float>();
  if constexpr (pcl::traits::has_normal<PointT>::value)
    point.getNormalVector3fMap() = foot.normal.template cast<float>();
  if constexpr (pcl::traits::has_field<PointT, pcl::fields::curvature>::value)
    point.curvature = static_cast<float>(0.5 * (foot.curvature1 + foot.curvature2));
  if constexpr (pcl::traits::has_field<PointT, pcl::fields::pc1>::value)
    point.pc1 = static_cast<float>(foot.curvature1);
  if constexpr (pcl::traits::has_field<PointT, pcl::fields::pc2>::value)
    point.pc2 = static_cast<float>(foot.curvature2);
  if constexpr (pcl::traits::has_field<PointT, pcl::fields::principal_curvature_x>::value) {
    point.principal_curvature_x = static_cast<float>(foot.direction1.x());
    point.principal_curvature_y = static_cast<float>(foot.direction1.y());
    point.principal_curvature_z = static_cast<float>(foot.direction1.z());
  }
}

/** The foot seen from the other side of the surface. */
inline SurfaceFoot
reversed(SurfaceFoot foot)
{
  foot.direction1 = foot.normal.cross(foot.direction1);
  foot.normal = -foot.normal;
  std::swap(foot.curvature1, foot.curvature2);
  foot.curvature1 = -foot.curvature1;
  foot.curvature2 = -foot.curvature2;
  return foot;
}

} // namespace detail

template <typename PointInT, typename PointOutT>
Status
MLSProjector<PointInT, PointOutT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the surface cloud is missing or empty; call setInputCloud with points"};
  if (queries_ && queries_->empty())
    return {StatusCode::InvalidInput, "the query cloud is empty; give it points, or none to project the input"};
  if (neighbours_ != 0 && neighbours_ < 6)
    return {StatusCode::InvalidArgument, "the number of neighbours is " + std::to_string(neighbours_) +
                                             "; set it to 6 or more, or 0 to follow the noise"};
  if (normals_ && normals_->size() != input_->size())
    return {StatusCode::InvalidInput, "there are " + std::to_string(normals_->size()) + " normals for " +
                                          std::to_string(input_->size()) + " points; give one a point"};
  return checkIndices(indices_.get(), input_->size());
}

template <typename PointInT, typename PointOutT>
std::vector<Eigen::Vector3d>
MLSProjector<PointInT, PointOutT>::queryPoints() const
{
  const PointCloudIn& cloud = queries_ ? *queries_ : *input_;
  std::vector<Eigen::Vector3d> points;
  if (queries_ || !indices_)
    for (const PointInT& p : cloud)
      points.push_back(p.getVector3fMap().template cast<double>());
  else
    for (const auto i : *indices_)
      points.push_back(cloud[i].getVector3fMap().template cast<double>());
  return points;
}

template <typename PointInT, typename PointOutT>
Status
MLSProjector<PointInT, PointOutT>::findSide(const SurfaceGraph& graph, const std::vector<std::uint32_t>& source,
                                            bool& flip) const
{
  flip = false;
  if (!normals_)
    return Status::success();
  std::size_t same = 0, other = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto& given = (*normals_)[source[graph.blocks().originalIndex(i)]];
    const float dot = graph.normals()[i].dot(given.getNormalVector3fMap());
    same += dot > 0.0f;
    other += dot < 0.0f;
  }
  flip = other > same;
  if (std::max(same, other) > 0 && 9 * std::min(same, other) <= std::max(same, other))
    return Status::success();
  return {StatusCode::InvalidInput, "the input normals have no common side: " + std::to_string(same) +
                                        " point to one, " + std::to_string(other) +
                                        " to the other; orient them, or give none"};
}

template <typename PointInT, typename PointOutT>
void
MLSProjector<PointInT, PointOutT>::write(const std::vector<SurfaceFoot>& feet, bool flip, PointCloudOut& output)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  SurfaceFoot nowhere;
  nowhere.position.setConstant(nan);
  nowhere.normal.setConstant(nan);
  nowhere.direction1.setConstant(nan);
  nowhere.curvature1 = nowhere.curvature2 = nan;
  output.clear();
  output.header = queries_ ? queries_->header : input_->header;
  output.resize(feet.size());
  output.is_dense = true;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const SurfaceFoot foot = !feet[i].valid ? nowhere : flip ? detail::reversed(feet[i]) : feet[i];
    detail::setFoot(output[i], foot);
    valid_.push_back(feet[i].valid);
    output.is_dense = output.is_dense && feet[i].valid;
    larger_curvature_.push_back(foot.curvature1);
    smaller_curvature_.push_back(foot.curvature2);
  }
  const PointCloudIn& cloud = queries_ ? *queries_ : *input_;
  if (feet.size() == cloud.size() && cloud.width * cloud.height == cloud.size()) {
    output.width = cloud.width;
    output.height = cloud.height;
  }
}

template <typename PointInT, typename PointOutT>
void
MLSProjector<PointInT, PointOutT>::compute(PointCloudOut& output)
{
  valid_.clear();
  larger_curvature_.clear();
  smaller_curvature_.clear();
  noise_ = 0.0;
  neighbours_used_ = 0;
  SurfaceGraph graph;
  UsablePoints usable;
  bool flip = false;
  status_ = check();
  if (status_.ok()) {
    usable = usablePoints(*input_, indices_.get());
    status_ = graph.build(std::move(usable.positions), {});
  }
  if (status_.ok())
    status_ = findSide(graph, usable.source, flip);
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::MLSProjector::compute] %s.\n", status_.message().c_str());
    output.clear();
    return;
  }
  const MlsSurface surface(graph, neighbours_, method_);
  std::vector<SurfaceFoot> feet;
  surface.project(queryPoints(), feet);
  noise_ = surface.noise();
  neighbours_used_ = surface.neighbours();
  write(feet, flip, output);
}

} // namespace pcl_spiral
