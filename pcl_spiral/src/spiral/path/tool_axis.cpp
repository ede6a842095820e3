// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/tool_axis.h>

#include "core/smooth_axes.h"
#include "core/tilted_axes.h"
#include <pcl_spiral/core/diagnostic.h>

#include <pcl/console/print.h>

#include <cmath>

namespace pcl_spiral {
Status
ToolAxis::check() const
{
  if (!path_)
    return {StatusCode::InvalidInput, "no path was given; call {setInputPath}"};
  if (path_->size() < 2)
    return {StatusCode::InvalidInput, Diagnostic("the path has ", path_->size(), " points; a feed direction needs at least 2")};
  for (double angle : {tilt_angle_, lead_angle_})
    if (!(std::abs(angle) <= 89.0))
      return {StatusCode::InvalidArgument, Diagnostic("the tilt or lead angle is ", angle, " {degrees}; set it between -89 and 89")};
  for (std::size_t i = 0; i < path_->size(); ++i) {
    const ToolpathPoint& p = (*path_)[i];
    if (!p.getVector3fMap().allFinite() || !p.getNormalVector3fMap().allFinite())
      return {StatusCode::InvalidInput, Diagnostic("path point ", i, " or its normal is not finite; remove it")};
    if (!(p.getNormalVector3fMap().squaredNorm() > 1e-12f))
      return {StatusCode::InvalidInput, Diagnostic("path point ", i, " has no normal; set normal_x, normal_y, normal_z before")};
  }
  return Status::success();
}

ToolAxis::Path::Ptr
ToolAxis::wantedAxes()
{
  Path::Ptr wanted(new Path(*path_));
  Polyline points;
  std::vector<Eigen::Vector3d> normals;
  for (const ToolpathPoint& p : *wanted) {
    points.push_back(p.getVector3fMap().cast<double>());
    normals.push_back(p.getNormalVector3fMap().cast<double>().normalized());
  }
  const auto axes = tiltedAxes(points, normals, tilt_angle_ * degree, lead_angle_ * degree);
  for (std::size_t i = 0; i < axes.size(); ++i)
    (*wanted)[i].getAxisVector3fMap() = axes[i].cast<float>();
  exceeded_moves_ = movesTurningFaster(points, normals, field_.getMaxAxisRate() * degree);
  return wanted;
}

void
ToolAxis::compute(Path& output)
{
  exceeded_moves_ = 0;
  status_ = check();
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::ToolAxis::compute] %s.\n", status_.message().c_str());
    output.clear();
    return;
  }
  field_.setInputPath(wantedAxes());
  field_.compute(output);
  field_.setInputPath(nullptr);
  status_ = field_.getStatus();
}

} // namespace pcl_spiral
