#pragma once

#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/verify/material_removal.h>

#include <limits>

namespace pcl_spiral {

template <typename PointT>
void
MaterialRemoval<PointT>::write(const RemovalHeights& heights, pcl::PointCloud<pcl::PointXYZI>& output)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const auto& cloud = *this->input_;
  std::vector<float> stock(cloud.size(), none), ridge(cloud.size(), none);
  for (std::size_t i = 0; i < heights.stock.size(); ++i) {
    const std::uint32_t at = this->surface_->cloudIndex(i);
    if (at >= cloud.size()) // the surface given is another cloud's
      continue;
    stock[at] = heights.stock[i];
    ridge[at] = heights.ridge[i];
  }
  const auto add = [&](std::size_t i) {
    pcl::PointXYZI point;
    point.getVector3fMap() = cloud[i].getVector3fMap();
    point.intensity = stock[i];
    output.push_back(point);
    ridge_heights_.push_back(ridge[i]);
  };
  if (this->indices_)
    for (const auto i : *this->indices_)
      add(static_cast<std::size_t>(i));
  else
    for (std::size_t i = 0; i < cloud.size(); ++i)
      add(i);
  output.header = cloud.header;
  output.is_dense = cloud.is_dense;
}

template <typename PointT>
void
MaterialRemoval<PointT>::compute(pcl::PointCloud<pcl::PointXYZI>& output)
{
  output.clear();
  ridge_heights_.clear();
  figures_ = RemovalFigures();
  const ThreadLimit limit(this->thread_count_);
  CutterPath path;
  RemovalHeights heights;
  this->status_ = this->prepare(path);
  if (this->status_.ok()) {
    const BallSweep ball(path.contacts, path.normals, tool_radius_);
    const RemovalSettings settings{tool_radius_, scallop_height_, this->chord_error_, reach_};
    this->status_ = measureRemovedMaterial(this->surface_->surface, path, ball, settings, this->progress_, heights,
                                           figures_);
  }
  if (!this->status_.ok()) {
    if (this->status_.code() != StatusCode::Cancelled)
      PCL_ERROR("[pcl_spiral::MaterialRemoval::compute] %s\n", this->status_.message().c_str());
    return;
  }
  write(heights, output);
}

} // namespace pcl_spiral
