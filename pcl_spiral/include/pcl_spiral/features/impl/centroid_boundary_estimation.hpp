// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/search/impl/pcl_search.hpp>
#include <pcl_spiral/search/impl/usable_points.h>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/features/impl/boundary.hpp>
#include <pcl/impl/pcl_base.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

template <typename PointInT, typename PointNT, typename PointOutT>
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::CentroidBoundaryEstimation()
{
  feature_name_ = "CentroidBoundaryEstimation";
  angle_threshold_ = static_cast<float>(121.0 * pi / 180.0);
  told_base_ = threadsOfBase(*this, 0);
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::checkSearch() const
{
  if (surface_ && surface_ != input_)
    return {StatusCode::InvalidInput, "a search surface other than the input cloud was set, but normals and results are "
                                      "those of the input; give the whole cloud to {setInputCloud}, choose points by "
                                      "{setIndices}, and leave {setSearchSurface}"};
  if (k_ != 0 && search_radius_ != 0.0)
    return {StatusCode::InvalidArgument, Diagnostic("both k (", k_, ") and radius (", search_radius_, ") are set; set one of them to 0")};
  if (k_ == 0 && search_radius_ == 0.0)
    return {StatusCode::InvalidArgument, "neither k nor radius is set; call {setKSearch}(32)"};
  if (k_ < 0 || k_ == 1 || k_ == 2 || k_ == 3)
    return {StatusCode::InvalidArgument, Diagnostic("k is ", k_, "; set it to 4 or more, 32 is recommended")};
  if (k_ == 0 && !(search_radius_ > 0.0 && std::isfinite(search_radius_)))
    return {StatusCode::InvalidArgument, Diagnostic("the search radius is ", search_radius_, "; set it to about 3 spacings of the points")};
  return Status::success();
}

template <typename PointInT, typename PointNT, typename PointOutT>
Status
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call {setInputCloud} with points"};
  if (!normals_ || normals_->size() != input_->size())
    return {StatusCode::InvalidInput, Diagnostic("there are ", normals_ ? normals_->size() : 0, " normals for ", input_->size(),
                                                 " points; call {setInputNormals} with one a point")};
  if (!(offset_threshold_ > 0.0) || !(angle_threshold_ > 0.0f))
    return {StatusCode::InvalidArgument, Diagnostic("the thresholds are ", offset_threshold_, " (offset) and ", angle_threshold_,
                                                    " (angle, radians); set both above 0")};
  if (const Status status = checkThreads(getNumberOfThreads()); !status.ok())
    return status;
  if (const Status status = checkIndices(Base::fake_indices_ ? nullptr : indices_.get(), input_->size()); !status.ok())
    return status;
  if (std::none_of(input_->begin(), input_->end(), [](const PointInT& p) { return pcl::isXYZFinite(p); }))
    return {StatusCode::InvalidInput, "no point of the input cloud is finite; check the file it came from"};
  return checkSearch();
}

template <typename PointInT, typename PointNT, typename PointOutT>
bool
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::initCompute()
{
  scores_.clear();
  offsets_.clear();
  gaps_.clear();
  status_ = check();
  if (status_.ok()) {
    if (!tree_)
      tree_.reset(new pcl::search::KdTree<PointInT>(false));
    if (rebuild_search_)
      tree_->setInputCloud(input_);
    rebuild_search_ = false;
    if (Base::initCompute())
      return true;
    status_ = {StatusCode::Failed, "PCL could not start the search; its message is above"};
  }
  PCL_ERROR("[pcl_spiral::CentroidBoundaryEstimation::compute] %s.\n", status_.message().c_str());
  return false;
}

template <typename PointInT, typename PointNT, typename PointOutT>
bool
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::evaluate(std::size_t index, BoundaryEvidence& evidence) const
{
  const PointInT& p = (*input_)[index];
  const Eigen::Vector3d normal = (*normals_)[index].getNormalVector3fMap().template cast<double>();
  if (!pcl::isXYZFinite(p) || !normal.allFinite() || normal.squaredNorm() == 0.0)
    return false;
  thread_local pcl::Indices neighbours;
  thread_local std::vector<float> distances;
  thread_local std::vector<Eigen::Vector2d> offsets;
  thread_local std::vector<double> angles;
  this->searchForNeighbors(index, search_parameter_, neighbours, distances);
  Eigen::Vector3d u, v;
  tangentFrame(normal.normalized(), u, v);
  offsets.clear();
  double farthest = 0.0;
  for (const auto neighbour : neighbours) {
    const PointInT& q = (*input_)[static_cast<std::size_t>(neighbour)];
    if (!pcl::isXYZFinite(q))
      continue;
    const Eigen::Vector3d d = q.getVector3fMap().template cast<double>() - p.getVector3fMap().template cast<double>();
    if (d.isZero(0.0))
      continue;
    offsets.emplace_back(d.dot(u), d.dot(v));
    farthest = std::max(farthest, d.norm());
  }
  if (offsets.size() < 3)
    return false;
  evidence = boundaryEvidence(offsets, search_radius_ > 0.0 ? search_radius_ : farthest, angles);
  return true;
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
CentroidBoundaryEstimation<PointInT, PointNT, PointOutT>::computeFeature(PointCloudOut& output)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto count = static_cast<std::ptrdiff_t>(indices_->size());
  scores_.assign(indices_->size(), nan);
  offsets_ = gaps_ = scores_;
  const ThreadLimit limit(getNumberOfThreads());
  bool all_evaluated = true;
#pragma omp parallel for schedule(dynamic, 1024) reduction(&& : all_evaluated)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    BoundaryEvidence evidence;
    output[at].boundary_point = 0;
    if (!evaluate(static_cast<std::size_t>((*indices_)[at]), evidence)) {
      all_evaluated = false;
      continue;
    }
    output[at].boundary_point = isBoundary(evidence, criterion_, offset_threshold_, angle_threshold_) ? 1 : 0;
    offsets_[at] = static_cast<float>(evidence.offset);
    gaps_[at] = static_cast<float>(evidence.gap);
    scores_[at] = static_cast<float>(std::exp(mu_ * evidence.offset));
  }
  output.is_dense = all_evaluated;
}

} // namespace pcl_spiral
