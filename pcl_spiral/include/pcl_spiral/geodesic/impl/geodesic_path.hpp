// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/type_traits.h>

#include <limits>
#include <optional>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
void
GeodesicPath<PointT, PointNT>::setTargetPoints(const Polyline& targets)
{
  targets_.clear();
  for (const Eigen::Vector3d& target : targets)
    targets_.push_back({target, false, 0});
}

template <typename PointT, typename PointNT>
void
GeodesicPath<PointT, PointNT>::setTargetIndices(const pcl::Indices& targets)
{
  targets_.clear();
  for (const pcl::index_t target : targets)
    targets_.push_back({Eigen::Vector3d::Zero(), true, target});
}

template <typename PointT, typename PointNT>
Status
GeodesicPath<PointT, PointNT>::checkPlace(const GivenPlace& place, const Diagnostic& name) const
{
  if (!place.by_index && !place.position.allFinite())
    return {StatusCode::InvalidArgument, Diagnostic("the ", name, " is not set, or not finite; give a position on the surface")};
  if (place.by_index && (!input_ || static_cast<std::size_t>(place.index) >= input_->size()))
    return {StatusCode::InvalidArgument,
            Diagnostic("the index of the ", name, ", ", place.index, ", is outside the cloud of ", input_ ? input_->size() : 0, " points")};
  if (place.by_index && !pcl::isXYZFinite((*input_)[place.index]))
    return {StatusCode::InvalidArgument, Diagnostic("the ", name, ", point ", place.index, " of the cloud, is not finite; choose another")};
  return Status::success();
}

template <typename PointT, typename PointNT>
Status
GeodesicPath<PointT, PointNT>::check() const
{
  if (fit_neighbours_ != 0 && fit_neighbours_ < 6)
    return {StatusCode::InvalidArgument,
            Diagnostic("a fit has ", fit_neighbours_, " neighbours; set 6 or more ({setKSearch}), better 32, or 0 to have them chosen")};
  if (targets_.empty())
    return {StatusCode::InvalidArgument, "there are no targets; call {setTargetPoints} or {setTargetIndices}"};
  Status status = checkPlace(source_, "source");
  for (std::size_t i = 0; status.ok() && i < targets_.size(); ++i)
    status = checkPlace(targets_[i], Diagnostic("target ", i));
  return status.ok() ? checkRefinement(options_) : status;
}

template <typename PointT, typename PointNT>
Eigen::Vector3d
GeodesicPath<PointT, PointNT>::positionOf(const GivenPlace& place) const
{
  return !place.by_index ? place.position : Eigen::Vector3d((*input_)[place.index].getVector3fMap().template cast<double>());
}

template <typename PointT, typename PointNT>
Status
GeodesicPath<PointT, PointNT>::run()
{
  const ThreadLimit limit(this->getNumberOfThreads());
  if (const Status status = this->checkInput(); !status.ok())
    return status;
  if (const Status status = check(); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface); !status.ok())
    return status;
  Polyline targets;
  for (const GivenPlace& target : targets_)
    targets.push_back(positionOf(target));
  std::optional<MlsSurface> own_fit;
  if (fit_neighbours_ > 0)
    own_fit.emplace(surface->graph(), fit_neighbours_);
  const Status status = shortestPaths(own_fit ? *own_fit : surface->fit(), positionOf(source_), targets, start_, options_, lines_);
  for (const GeodesicLine& line : lines_)
    lengths_.push_back(line.points.empty() || line.left_surface ? std::numeric_limits<double>::quiet_NaN() : line.length);
  return status;
}

template <typename PointT, typename PointNT>
void
GeodesicPath<PointT, PointNT>::compute(std::vector<Polyline>& paths)
{
  lines_.clear();
  lengths_.clear();
  paths.clear();
  this->computeBy("GeodesicPath", [&] { return run(); });
  paths.assign(targets_.size(), Polyline());
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (!lines_[i].left_surface)
      paths[i] = lines_[i].points;
}

template <typename PointT, typename PointNT>
void
GeodesicPath<PointT, PointNT>::compute(std::vector<PointCloud>& paths)
{
  paths.clear();
  std::vector<Polyline> lines;
  compute(lines);
  paths.assign(lines.size(), PointCloud());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (input_)
      paths[i].header = input_->header;
    for (std::size_t k = 0; k < lines[i].size(); ++k) {
      PointT point;
      point.getVector3fMap() = lines[i][k].template cast<float>();
      if constexpr (pcl::traits::has_normal<PointT>::value)
        point.getNormalVector3fMap() = lines_[i].feet[k].normal.template cast<float>();
      paths[i].push_back(point);
    }
  }
}

} // namespace pcl_spiral
