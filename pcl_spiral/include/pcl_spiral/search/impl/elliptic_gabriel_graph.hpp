// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/search/elliptic_gabriel_graph.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <cmath>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
EllipticGabrielGraph<PointT, PointNT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call {setInputCloud} with points"};
  if (!(options_.alpha > 0.0) || options_.alpha * options_.alpha > 2.0 + 1e-12)
    return {StatusCode::InvalidArgument, Diagnostic("alpha is ", options_.alpha, "; set it above 0 and not above 1.4142")};
  if (options_.candidates < 1)
    return {StatusCode::InvalidArgument, Diagnostic("the number of candidates is ", options_.candidates, "; set it to 1 or more")};
  if (!(options_.max_edge >= 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the longest edge is ", options_.max_edge, " spacings; set it above 0, or 0 for any")};
  if (!(max_normal_angle_ >= 0.0 && max_normal_angle_ <= 180.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("the largest angle between normals is ", max_normal_angle_, " {degrees}; set it between 0 and 180")};
  if (max_normal_angle_ > 0.0 && (!normals_ || normals_->size() != input_->size()))
    return {StatusCode::InvalidInput,
            Diagnostic("the angle between normals needs one normal a point: there are ", normals_ ? normals_->size() : 0, " for ",
                       input_->size(), " points; call {setInputNormals}")};
  if (const Status status = checkThreads(options_.threads); !status.ok())
    return status;
  return checkIndices(indices_.get(), input_->size());
}

template <typename PointT, typename PointNT>
std::vector<std::uint32_t>
EllipticGabrielGraph<PointT, PointNT>::usablePoints() const
{
  std::vector<bool> wanted(input_->size(), !indices_);
  if (indices_)
    for (const auto index : *indices_)
      wanted[static_cast<std::size_t>(index)] = true;
  std::vector<std::uint32_t> usable;
  for (std::size_t i = 0; i < input_->size(); ++i)
    if (wanted[i] && pcl::isXYZFinite((*input_)[i]) && (max_normal_angle_ == 0.0 || pcl::isNormalFinite((*normals_)[i])))
      usable.push_back(static_cast<std::uint32_t>(i));
  return usable;
}

template <typename PointT, typename PointNT>
void
EllipticGabrielGraph<PointT, PointNT>::compute(NeighbourLists& graph)
{
  graph = NeighbourLists();
  status_ = check();
  const std::vector<std::uint32_t> usable = status_.ok() ? usablePoints() : std::vector<std::uint32_t>();
  if (status_.ok() && usable.empty())
    status_ = {StatusCode::InvalidInput, "none of the points to join is finite; check the cloud, its normals and indices"};
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::EllipticGabrielGraph::compute] %s.\n", status_.message().c_str());
    return;
  }
  std::vector<Eigen::Vector3f> points, normals;
  for (const std::uint32_t i : usable) {
    points.push_back((*input_)[i].getVector3fMap());
    if (max_normal_angle_ > 0.0)
      normals.push_back((*normals_)[i].getNormalVector3fMap().normalized());
  }
  const ThreadLimit limit(options_.threads);
  GabrielOptions options = options_;
  options.max_normal_angle = max_normal_angle_ * pi / 180.0;
  graph = ellipticGabrielEdges(points, normals, options).mapped(usable, input_->size());
}

} // namespace pcl_spiral
