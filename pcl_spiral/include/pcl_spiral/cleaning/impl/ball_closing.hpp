// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <utility>
#include <vector>

namespace pcl_spiral {

template <typename PointT>
Status
BallClosing<PointT>::run()
{
  if (const Status status = checkThreads(thread_count_); !status.ok())
    return status;
  const ThreadLimit limit(thread_count_);
  if (!this->input_ || this->input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty: call {setInputCloud} with points"};
  if (!(radius_ > 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the tool radius is ", radius_, " {mm}: it must be above 0 {mm} ({setToolRadius})")};
  if (!(rounding_ >= 0.0) || !(rounding_ < radius_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the rounding is ", rounding_, " {mm}: it must be 0 {mm} or more, and less than the tool radius ({setRounding})")};
  const pcl::Indices* const indices = this->fake_indices_ ? nullptr : this->indices_.get();
  if (const Status status = checkIndices(indices, this->input_->size()); !status.ok())
    return status;
  const UsablePoints usable = usablePoints(*this->input_, indices);
  if (usable.positions.empty())
    return {StatusCode::InvalidInput, "no point is finite: check the {scan}, or the columns of its file"};
  const Eigen::Vector3f sensor = this->input_->sensor_origin_.template head<3>();
  std::optional<Eigen::Vector3d> view_point = view_point_;
  if (!view_point && sensor.allFinite() && !sensor.isZero(0.0f))
    view_point = sensor.cast<double>();
  Eigen::Vector3d along = Eigen::Vector3d::UnitZ();
  if (direction_)
    along = *direction_;
  else if (view_point)
    along = *view_point - middleOf(usable.positions);
  if (!(along.norm() > 1e-9) || !along.allFinite())
    return {StatusCode::InvalidArgument, Diagnostic("the direction of the tool is ", Direction(along),
                                                    ": give one such as (0, 0, 1) "
                                                    "({setDirection}), or a view point away from the {scan} ({setViewPoint})")};
  const std::vector<Eigen::Vector3f> obstacles = obstacles_ ? usablePoints(*obstacles_, nullptr).positions : std::vector<Eigen::Vector3f>();
  if (const Status status = closeByBall(usable.positions, obstacles, along.normalized(), radius_, rounding_, view_); !status.ok())
    return status;
  figures_ = {usable.positions.size(), view_.covered, view_.spacing, view_.grid.cell};
  return Status::success();
}

template <typename PointT>
void
BallClosing<PointT>::compute(pcl::PointCloud<pcl::PointXYZ>& closed)
{
  view_ = ClosedView();
  figures_ = ClosingReport();
  status_ = Status::unfinished();
  status_ = run(); // reads the input, which may be the same cloud
  closed.clear();
  if (!status_.ok()) {
    view_ = ClosedView();
    if (!quiet_)
      PCL_ERROR("[pcl_spiral::BallClosing::compute] %s\n", status_.message().c_str());
    return;
  }
  closed.header = this->input_->header;
  closed.reserve(view_.points.size());
  for (const Eigen::Vector3f& p : std::exchange(view_.points, {}))
    closed.push_back({p.x(), p.y(), p.z()});
}

} // namespace pcl_spiral
