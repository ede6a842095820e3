// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/verify/deviation_estimation.h>

namespace pcl_spiral {

template <typename PointT>
void
DeviationEstimation<PointT>::compute(pcl::PointCloud<pcl::PointXYZI>& output)
{
  output.clear();
  figures_ = DeviationReport();
  const ThreadLimit limit(this->getNumberOfThreads());
  CutterPath path;
  std::vector<float> deviation;
  const auto run = [&] {
    const Status status = this->prepare(path);
    return status.ok() ? measureDeviation(*this->reference_, path, this->chord_error_, this->progress_, deviation, figures_) : status;
  };
  if (!this->computeBy("DeviationEstimation", run))
    return;
  output.resize(path.size());
  output.header = this->toolpath_->header;
  for (std::size_t i = 0; i < path.size(); ++i) {
    output[i].getVector3fMap() = (*this->toolpath_)[i].getVector3fMap();
    output[i].intensity = deviation[i];
  }
}

} // namespace pcl_spiral
