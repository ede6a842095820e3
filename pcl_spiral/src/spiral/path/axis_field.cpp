// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/axis_field.h>

#include "core/smooth_axes.h"
#include <pcl_spiral/core/diagnostic.h>

#include <pcl/console/print.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr float shortest_vector = 1e-6f;

} // namespace

Status
AxisField::check() const
{
  if (!path_ || path_->empty())
    return {StatusCode::InvalidInput, "no path was given; call {setInputPath}"};
  if (!(smoothing_length_ >= 0.0) || !std::isfinite(smoothing_length_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the smoothing length is ", smoothing_length_, " {mm}; set it above 0, or 0 for no smoothing")};
  if (!(max_deviation_ > 0.0) || !(max_deviation_ <= 180.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("the largest deviation is ", max_deviation_, " {degrees}; set it above 0 and up to 180")};
  if (!(max_axis_rate_ >= 0.0) || !std::isfinite(max_axis_rate_))
    return {StatusCode::InvalidArgument,
            Diagnostic("the axis rate is ", max_axis_rate_, " {degrees} per {mm}; set it above 0, or 0 for no limit")};
  for (std::size_t i = 0; i < path_->size(); ++i) {
    const ToolpathPoint& p = (*path_)[i];
    if (!p.getVector3fMap().allFinite() || !p.getNormalVector3fMap().allFinite() || !p.getAxisVector3fMap().allFinite())
      return {StatusCode::InvalidInput, Diagnostic("path point ", i, ", its normal or its axis is not finite; remove it")};
    if (!(p.getAxisVector3fMap().norm() > shortest_vector))
      return {StatusCode::InvalidInput, Diagnostic("path point ", i, " has no axis; set axis_x, axis_y, axis_z before")};
  }
  return Status::success();
}

Status
AxisField::smooth(Path& output)
{
  Polyline points;
  std::vector<Eigen::Vector3d> wanted, normals;
  for (const ToolpathPoint& p : *path_) {
    points.push_back(p.getVector3fMap().cast<double>());
    wanted.push_back(p.getAxisVector3fMap().cast<double>().normalized());
    if (p.getNormalVector3fMap().norm() > shortest_vector)
      normals.push_back(p.getNormalVector3fMap().cast<double>().normalized());
  }
  const SmoothAxes field = smoothAxes(points, wanted, {smoothing_length_, max_deviation_ * degree, max_axis_rate_ * degree});
  largest_change_ = field.largest_change / degree;
  largest_rate_ = field.largest_rate / degree;
  largest_deviation_ = field.largest_deviation / degree;
  deviating_points_ = field.deviating_points;
  if (normals.size() == points.size()) {
    const AxisLean lean = largestLean(normals, field.axes);
    largest_lean_ = lean.angle / degree;
    if (liesInSurface(lean, normals, wanted))
      return {StatusCode::Failed, Diagnostic("the axis would lean ", largest_lean_, " {degrees} from the normal at path point ", lean.point,
                                             " to keep the axis rate of ", max_axis_rate_,
                                             " {degrees} per {mm}: raise the axis rate, or round the path there")};
  }
  if (&output != path_.get())
    output = *path_;
  for (std::size_t i = 0; i < output.size(); ++i)
    output[i].getAxisVector3fMap() = field.axes[i].cast<float>();
  return Status::success();
}

void
AxisField::compute(Path& output)
{
  largest_change_ = largest_rate_ = largest_deviation_ = largest_lean_ = 0.0;
  deviating_points_ = 0;
  status_ = check();
  if (status_.ok())
    status_ = smooth(output);
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::AxisField::compute] %s.\n", status_.message().c_str());
    output.clear();
  }
}

} // namespace pcl_spiral
