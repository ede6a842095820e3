#pragma once

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/toolpath/drive_path.h>
#include <pcl_spiral/toolpath/drive_planner.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

namespace pcl_spiral {

template <typename PointT>
Status
DrivePath<PointT>::run(DrivePasses& passes)
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (const Status status = checkIndices(indices_.get(), input_->size()); !status.ok())
    return status;
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  if (thread_count_ < 0)
    return {StatusCode::InvalidArgument,
            textOf("the number of threads is ", thread_count_, "; set 0 for all, or a count")};
  const ThreadLimit limit(thread_count_);
  return planDrive(usablePoints(*input_, indices_.get()).positions, settings_, progress_, passes, report_);
}

template <typename PointT>
void
DrivePath<PointT>::compute(DrivePasses& passes)
{
  passes.clear();
  report_ = DriveReport();
  status_ = run(passes);
  if (!status_.ok())
    passes.clear();
  if (!status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::DrivePath::compute] %s.\n", status_.message().c_str());
}

} // namespace pcl_spiral
