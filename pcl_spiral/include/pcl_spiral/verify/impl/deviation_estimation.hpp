#pragma once

#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/verify/deviation_estimation.h>

namespace pcl_spiral {

template <typename PointT>
void
DeviationEstimation<PointT>::compute(pcl::PointCloud<pcl::PointXYZI>& output)
{
  output.clear();
  figures_ = DeviationFigures();
  const ThreadLimit limit(this->thread_count_);
  CutterPath path;
  std::vector<float> deviation;
  this->status_ = this->prepare(path);
  if (this->status_.ok())
    this->status_ = measureDeviation(this->surface_->surface, path, this->chord_error_, this->progress_, deviation,
                                     figures_);
  if (!this->status_.ok()) {
    if (this->status_.code() != StatusCode::Cancelled)
      PCL_ERROR("[pcl_spiral::DeviationEstimation::compute] %s\n", this->status_.message().c_str());
    return;
  }
  output.resize(path.size());
  output.header = this->toolpath_->header;
  for (std::size_t i = 0; i < path.size(); ++i) {
    output[i].getVector3fMap() = (*this->toolpath_)[i].getVector3fMap();
    output[i].intensity = deviation[i];
  }
}

} // namespace pcl_spiral
