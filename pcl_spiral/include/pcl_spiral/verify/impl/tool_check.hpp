// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/usable_points.h>
#include <pcl_spiral/verify/impl/tool_check.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <cmath>

namespace pcl_spiral {

template <typename PointT>
Status
ToolCheck<PointT>::checkCloud() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call {setInputCloud} with points"};
  return checkIndices(this->fake_indices_ ? nullptr : indices_.get(), input_->size());
}

template <typename PointT>
Status
ToolCheck<PointT>::checkTool() const
{
  for (const Diagnostic& fault : {faultOf(cutter_), faultOf(holder_)})
    if (!fault.empty())
      return {StatusCode::InvalidArgument, fault};
  if (!(holder_clearance_ >= 0.0) || !std::isfinite(holder_clearance_))
    return {StatusCode::InvalidArgument, Diagnostic("the holder's clearance is ", holder_clearance_, " {mm}; set it to 0 or more")};
  if (!(tolerance_ > 0.0) || !std::isfinite(tolerance_))
    return {StatusCode::InvalidArgument, Diagnostic("the tolerance is ", tolerance_, " {mm}; set it above 0")};
  return checkThreads(thread_count_);
}

template <typename PointT>
HolderProfile
ToolCheck<PointT>::holderProfile() const
{
  const CutterProfile cutter(cutter_);
  return HolderProfile(holder_, cutter.topHeight(), cutter.radius(), holder_clearance_);
}

template <typename PointT>
template <typename Find>
Status
ToolCheck<PointT>::findAmongPoints(Find find)
{
  const ThreadLimit limit(thread_count_);
  const PointBlocks points(usablePoints(*input_, indices_.get()).positions);
  if (points.size() == 0)
    return {StatusCode::InvalidInput, "no point of the cloud is finite; check the scan"};
  if (const Status status = find(points, figures_); !status.ok())
    return status;
  obstacle_figures_ = figures_;
  if (figures_.collided == 0 || largest_echo_ == 0)
    return Status::success();
  std::vector<Eigen::Vector3f> obstacles = withoutEchoes(points.points(), largest_echo_);
  return obstacles.size() < points.size() ? find(PointBlocks(std::move(obstacles)), obstacle_figures_) : Status::success();
}

template <typename PointT>
template <typename Find>
void
ToolCheck<PointT>::report(const char* name, Find find)
{
  figures_ = obstacle_figures_ = LeadReport();
  status_ = Status::unfinished();
  status_ = find();
  if (!status_.ok())
    figures_ = obstacle_figures_ = LeadReport();
  if (!quiet_ && !status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::%s::compute] %s\n", name, status_.message().c_str());
}

} // namespace pcl_spiral
