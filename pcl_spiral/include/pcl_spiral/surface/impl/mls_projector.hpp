// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/surface/mls_projector.h>

#include <pcl/common/io.h>
#include <pcl/surface/impl/processing.hpp>
#include <pcl/type_traits.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace detail {

/** Set the fields of \p point from the position, normal and curvatures of a foot. */
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

} // namespace detail

template <typename PointInT, typename PointOutT>
void
MLSProjector<PointInT, PointOutT>::setPolynomialOrder(int order)
{
  order_ = order;
  if (order == 0 || order == 2)
    method_ = order == 0 ? Method::DirectionalCentroid : Method::Quadratic;
}

template <typename PointInT, typename PointOutT>
Status
MLSProjector<PointInT, PointOutT>::check() const
{
  if (queries_ && queries_->empty())
    return {StatusCode::InvalidInput, "the query cloud is empty: give it points, or none to project the input"};
  if (neighbours_ != 0 && neighbours_ < 6)
    return {StatusCode::InvalidArgument,
            Diagnostic("the number of neighbours is ", neighbours_, ": set 6 or more ({setKSearch}), or 0 to follow the noise")};
  if (!(search_radius_ >= 0.0) || !std::isfinite(search_radius_) || (search_radius_ > 0.0 && neighbours_ > 0))
    return {StatusCode::InvalidArgument, Diagnostic("the search radius is ", search_radius_, " {mm} and k is ", neighbours_,
                                                    ": set one of them above 0 and the other to 0 ({setSearchRadius}, {setKSearch})")};
  if (order_ != 0 && order_ != 2)
    return {StatusCode::InvalidArgument, Diagnostic("the polynomial order is ", order_,
                                                    ": set 2 for a quadric or 0 for the directional centroid ({setPolynomialOrder})")};
  if (search_)
    return {StatusCode::InvalidArgument, "a search method was set, but neighbours are found by a search of the projector's "
                                         "own: leave {setSearchMethod} out, or set it to null"};
  return Status::success();
}

template <typename PointInT, typename PointOutT>
typename MLSProjector<PointInT, PointOutT>::PointCloudInConstPtr
MLSProjector<PointInT, PointOutT>::wholeQueryCloud() const
{
  return queries_ ? queries_ : this->input_ && !this->givenIndices() ? this->input_ : nullptr;
}

template <typename PointInT, typename PointOutT>
std::vector<Eigen::Vector3d>
MLSProjector<PointInT, PointOutT>::queryPoints(const Surface& surface) const
{
  std::vector<Eigen::Vector3d> points;
  if (const auto cloud = wholeQueryCloud())
    for (const PointInT& p : *cloud)
      points.push_back(p.getVector3fMap().template cast<double>());
  else if (this->input_)
    for (const auto i : *this->indices_)
      points.push_back((*this->input_)[i].getVector3fMap().template cast<double>());
  else
    for (std::size_t i = 0; i < surface.size(); ++i)
      points.push_back(surface.position(i));
  return points;
}

template <typename PointInT, typename PointOutT>
Status
MLSProjector<PointInT, PointOutT>::run(std::vector<SurfaceFoot>& feet)
{
  constexpr double fewest = 6.0;
  const ThreadLimit limit(this->getNumberOfThreads());
  if (const Status status = check(); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface, {}, nullptr); !status.ok())
    return status;
  int neighbours = neighbours_;
  if (search_radius_ > 0.0) {
    const double radius = search_radius_ / surface->spacing(), inside = std::round(pi * radius * radius);
    if (inside < fewest)
      return {StatusCode::InvalidArgument,
              Diagnostic("the search radius is ", search_radius_, " {mm}, where points lie ", surface->spacing(), " {mm} apart: set it to ",
                         2.0 * surface->spacing(), " {mm} or more ({setSearchRadius})")};
    neighbours = static_cast<int>(std::min(inside, static_cast<double>(surface->size())));
  }
  const MlsSurface fit(surface->graph(), neighbours, method_);
  fit.project(queryPoints(*surface), feet);
  noise_ = fit.noise();
  neighbours_used_ = fit.neighbours();
  return Status::success();
}

template <typename PointInT, typename PointOutT>
void
MLSProjector<PointInT, PointOutT>::write(const std::vector<SurfaceFoot>& feet, PointCloudOut& output)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  SurfaceFoot nowhere;
  nowhere.position.setConstant(nan);
  nowhere.normal.setConstant(nan);
  nowhere.direction1.setConstant(nan);
  nowhere.curvature1 = nowhere.curvature2 = nan;
  PointCloudOut made;
  made.resize(feet.size());
  const PointCloudInConstPtr source = queries_ ? queries_ : this->input_;
  if (source) {
    made.header = source->header;
    made.sensor_origin_ = source->sensor_origin_;
    made.sensor_orientation_ = source->sensor_orientation_;
    const bool all = wholeQueryCloud() != nullptr;
    for (std::size_t i = 0; i < feet.size(); ++i)
      pcl::copyPoint((*source)[all ? i : static_cast<std::size_t>((*this->indices_)[i])], made[i]);
  }
  made.is_dense = true;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const SurfaceFoot& foot = feet[i].valid ? feet[i] : nowhere;
    detail::setFoot(made[i], foot);
    valid_.push_back(feet[i].valid);
    made.is_dense = made.is_dense && feet[i].valid;
    larger_curvature_.push_back(foot.curvature1);
    smaller_curvature_.push_back(foot.curvature2);
  }
  const auto cloud = wholeQueryCloud();
  if (cloud && cloud->width * cloud->height == feet.size()) {
    made.width = cloud->width;
    made.height = cloud->height;
  }
  output = std::move(made); // output may be the cloud that was projected
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
  if (static_cast<const void*>(&output) != this->input_.get() && static_cast<const void*>(&output) != queries_.get())
    output.clear();
  std::vector<SurfaceFoot> feet;
  if (this->computeBy("MLSProjector", [&] { return run(feet); }))
    write(feet, output);
  else
    output.clear();
}

} // namespace pcl_spiral
