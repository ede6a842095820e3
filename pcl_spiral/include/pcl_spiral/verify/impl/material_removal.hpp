// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>
#include <pcl_spiral/verify/material_removal.h>

#include <limits>
#include <memory>

namespace pcl_spiral {

/** Checks that the heights, one per point of the cloud of which the surface was made, belong to the cloud given. */
template <typename PointT>
Status
MaterialRemoval<PointT>::checkCloud() const
{
  const std::size_t made_of = this->reference_->scanned().inputSize();
  if (!this->input_ || this->input_->size() == made_of)
    return Status::success();
  return {StatusCode::InvalidInput,
          Diagnostic("the cloud has ", this->input_->size(), " points, but the surface to judge by was made of a cloud of ", made_of,
                     ": give the cloud that it was made of ({setInputCloud} before {setInputSurface}), or the surface alone")};
}

template <typename PointT>
void
MaterialRemoval<PointT>::write(const RemovalHeights& heights, pcl::PointCloud<pcl::PointXYZI>& output)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const Surface& surface = this->reference_->scanned();
  const std::size_t size = this->input_ ? this->input_->size() : surface.inputSize();
  std::vector<float> stock(size, none), ridge(size, none);
  std::vector<Eigen::Vector3f> places(this->input_ ? 0 : size, Eigen::Vector3f::Constant(none));
  for (std::size_t i = 0; i < heights.stock.size(); ++i) {
    const std::uint32_t at = surface.sourceIndex(i);
    if (at >= size) // added in a gap
      continue;
    stock[at] = heights.stock[i];
    ridge[at] = heights.ridge[i];
    if (!this->input_)
      places[at] = surface.graph().blocks().point(i);
  }
  const auto add = [&](std::size_t i) {
    pcl::PointXYZI point;
    point.getVector3fMap() = this->input_ ? Eigen::Vector3f((*this->input_)[i].getVector3fMap()) : places[i];
    point.intensity = stock[i];
    output.push_back(point);
    ridge_heights_.push_back(ridge[i]);
  };
  if (this->input_ && this->givenIndices())
    for (const auto i : *this->indices_)
      add(static_cast<std::size_t>(i));
  else
    for (std::size_t i = 0; i < size; ++i)
      add(i);
  if (this->input_)
    output.header = this->input_->header;
  output.is_dense = this->input_ && this->input_->is_dense;
}

template <typename PointT>
void
MaterialRemoval<PointT>::compute(pcl::PointCloud<pcl::PointXYZI>& output)
{
  output.clear();
  ridge_heights_.clear();
  figures_ = RemovalReport();
  const ThreadLimit limit(this->getNumberOfThreads());
  CutterPath path;
  RemovalHeights heights;
  const auto run = [&]() -> Status {
    if (const Status status = this->prepare(path); !status.ok())
      return status;
    if (const Status status = checkCloud(); !status.ok())
      return status;
    std::unique_ptr<CutterSweep> sweep;
    if (const Status status = makeSweep(path, cutter_, tips_, sweep); !status.ok())
      return status;
    return measureRemovedMaterial(*this->reference_, path, *sweep, removalSettings(cutter_, scallop_height_, this->chord_error_, reach_),
                                  this->progress_, heights, figures_);
  };
  if (!this->computeBy("MaterialRemoval", run))
    return;
  write(heights, output);
}

} // namespace pcl_spiral
