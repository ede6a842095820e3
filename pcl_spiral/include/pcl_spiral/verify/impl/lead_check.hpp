// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/search/impl/usable_points.h>
#include <pcl_spiral/verify/lead_check.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <cmath>
#include <utility>

namespace pcl_spiral {

template <typename PointT>
Status
LeadCheck<PointT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (const Status status = checkIndices(this->fake_indices_ ? nullptr : indices_.get(), input_->size()); !status.ok())
    return status;
  for (const std::string& fault : {faultOf(cutter_), faultOf(holder_)})
    if (!fault.empty())
      return {StatusCode::InvalidArgument, fault};
  if (!(holder_clearance_ >= 0.0) || !std::isfinite(holder_clearance_))
    return {StatusCode::InvalidArgument, textOf("the holder's clearance is ", holder_clearance_, " mm; set it to 0 or more")};
  if (!(tolerance_ > 0.0) || !std::isfinite(tolerance_))
    return {StatusCode::InvalidArgument, textOf("the tolerance is ", tolerance_, " mm; set it above 0")};
  return checkThreads(thread_count_);
}

template <typename PointT>
void
LeadCheck<PointT>::compute(const MachineProgram& program)
{
  figures_ = LeadFigures();
  status_ = check();
  if (status_.ok()) {
    const ThreadLimit limit(thread_count_);
    std::vector<Eigen::Vector3f> points = usablePoints(*input_, indices_.get()).positions;
    const CutterProfile cutter(cutter_);
    const HolderProfile holder(holder_, cutter.topHeight(), cutter.radius(), holder_clearance_);
    status_ = points.empty() ? Status(StatusCode::InvalidInput, "no point of the cloud is finite; check the scan")
                             : findLeadCollisions(PointBlocks(std::move(points)), cutter, holder, program, tolerance_, progress_, figures_);
  }
  if (!status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::LeadCheck::compute] %s\n", status_.message().c_str());
}

} // namespace pcl_spiral
