// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/surface/surface_preparation.h>

#include <pcl/filters/impl/filter.hpp>

#include <vector>

namespace pcl_spiral {

template <typename PointT>
void
SurfacePreparation<PointT>::forget()
{
  status_ = Status();
  counts_ = SurfaceReport();
  source_indices_.clear();
  surface_.reset();
  this->removed_indices_->clear();
}

template <typename PointT>
void
SurfacePreparation<PointT>::filter(PointCloud& output)
{
  if (this->input_) {
    pcl::Filter<PointT>::filter(output);
    return;
  }
  forget();
  output.clear();
  status_ = missingCloud();
  PCL_ERROR("[pcl_spiral::SurfacePreparation::filter] %s\n", status_.message().c_str());
}

template <typename PointT>
void
SurfacePreparation<PointT>::applyFilter(PointCloud& output)
{
  forget();
  output.clear();
  scanned_.setInputCloud(this->input_);
  scanned_.setIndices(this->fake_indices_ ? nullptr : this->indices_);
  scanned_.setQuiet(true);
  scanned_.compute(surface_);
  status_ = scanned_.getStatus();
  if (!status_.ok())
    PCL_ERROR("[pcl_spiral::SurfacePreparation::filter] %s\n", status_.message().c_str());
  output.is_dense = true;
  if (!surface_)
    return;
  counts_ = surface_->report();
  std::vector<std::uint8_t> kept(this->input_->size(), 0);
  output.reserve(surface_->size());
  for (std::size_t i = 0; i < surface_->size(); ++i) {
    source_indices_.push_back(static_cast<pcl::index_t>(surface_->sourceIndex(i)));
    kept[source_indices_.back()] = 1;
    output.push_back((*this->input_)[source_indices_.back()]);
  }
  if (!this->extract_removed_indices_)
    return;
  const auto take = [&](std::size_t i) {
    if (!kept[i])
      this->removed_indices_->push_back(static_cast<pcl::index_t>(i));
  };
  if (this->indices_ && !this->fake_indices_)
    for (const auto i : *this->indices_)
      take(static_cast<std::size_t>(i));
  else
    for (std::size_t i = 0; i < kept.size(); ++i)
      take(i);
}

template <typename PointT>
void
SurfacePreparation<PointT>::compute(PointCloud& cloud, pcl::PointCloud<pcl::Normal>& normals)
{
  PointCloud kept;
  applyFilter(kept);
  normals.clear();
  if (this->input_)
    kept.header = this->input_->header;
  for (std::size_t i = 0; surface_ && i < surface_->size(); ++i) {
    const Eigen::Vector3f& n = surface_->graph().normals()[i];
    normals.push_back(pcl::Normal(n.x(), n.y(), n.z()));
  }
  normals.is_dense = true;
  normals.header = kept.header;
  cloud = std::move(kept);
}

} // namespace pcl_spiral
