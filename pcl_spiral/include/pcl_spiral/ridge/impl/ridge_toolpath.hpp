// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/ridge/ridge_toolpath.h>

#include <pcl/console/print.h>

namespace pcl_spiral {

template <typename PointT>
Status
RidgeToolpath<PointT>::run(DrivePasses& passes)
{
  if (const Status status = checkThreads(this->getNumberOfThreads()); !status.ok())
    return status;
  const ThreadLimit limit(this->getNumberOfThreads());
  if (!this->input_ || this->input_->empty() || !this->initCompute())
    return {StatusCode::InvalidInput, "the rail is missing or empty: call {setInputCloud} with its points"};
  Polyline rail, generator;
  bool inside = true;
  for (const auto index : *this->indices_) {
    inside = inside && index >= 0 && static_cast<std::size_t>(index) < this->input_->size();
    if (inside)
      rail.push_back((*this->input_)[static_cast<std::size_t>(index)].getVector3fMap().template cast<double>());
  }
  this->deinitCompute();
  if (!inside)
    return {StatusCode::InvalidArgument, "an index is outside the cloud of the rail: give indices of its points ({setIndices})"};
  if (!generator_ || generator_->empty())
    return {StatusCode::InvalidInput, "the generator is missing or empty: call {setInputGenerator} with its points"};
  for (const PointT& p : *generator_)
    generator.push_back(p.getVector3fMap().template cast<double>());
  if (const Status status = RidgeSurface::make(rail, generator, settings_, ridge_); !status.ok())
    return status;
  return planRidgeRows(*ridge_, rows_, passes, report_);
}

template <typename PointT>
void
RidgeToolpath<PointT>::compute(DrivePasses& passes)
{
  passes.clear();
  ridge_.reset();
  report_ = RidgeRowReport();
  status_ = Status::unfinished();
  status_ = run(passes);
  if (!status_.ok())
    passes.clear();
  if (!quiet_ && !status_.ok())
    PCL_ERROR("[pcl_spiral::RidgeToolpath::compute] %s\n", status_.message().c_str());
}

} // namespace pcl_spiral
