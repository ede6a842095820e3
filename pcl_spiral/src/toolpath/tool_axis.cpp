#include <pcl_spiral/core/tool_axis.h>
#include <pcl_spiral/toolpath/tool_axis.h>

#include <pcl/console/print.h>

#include <cmath>
#include <sstream>

namespace pcl_spiral {

namespace {

constexpr double radians = 3.14159265358979323846 / 180.0;

template <typename Value>
std::string
text(const std::string& before, Value value, const std::string& after)
{
  std::ostringstream message;
  message << before << value << after;
  return message.str();
}

} // namespace

Status
ToolAxis::check() const
{
  if (!path_)
    return {StatusCode::InvalidInput, "no path was given; call setInputPath"};
  if (path_->size() < 2)
    return {StatusCode::InvalidInput,
            text("the path has ", path_->size(), " points; a feed direction needs at least 2")};
  for (double angle : {tilt_angle_, lead_angle_})
    if (!(std::abs(angle) <= 89.0))
      return {StatusCode::InvalidArgument,
              text("the tilt or lead angle is ", angle, " degrees; set it between -89 and 89")};
  if (!(max_axis_rate_ >= 0.0) || !std::isfinite(max_axis_rate_))
    return {StatusCode::InvalidArgument,
            text("the axis rate is ", max_axis_rate_, " degrees per mm; set it above 0, or 0 for no limit")};
  for (std::size_t i = 0; i < path_->size(); ++i) {
    const ToolpathPoint& p = (*path_)[i];
    if (!p.getVector3fMap().allFinite() || !p.getNormalVector3fMap().allFinite())
      return {StatusCode::InvalidInput, text("path point ", i, " or its normal is not finite; remove it")};
    if (!(p.getNormalVector3fMap().squaredNorm() > 1e-12f))
      return {StatusCode::InvalidInput,
              text("path point ", i, " has no normal; set normal_x, normal_y, normal_z before")};
  }
  return Status::success();
}

void
ToolAxis::compute(Path& output)
{
  status_ = check();
  largest_change_ = largest_rate_ = largest_reduction_ = 0.0;
  limited_points_ = exceeded_moves_ = 0;
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::ToolAxis::compute] %s.\n", status_.message().c_str());
    output.clear();
    return;
  }
  if (&output != path_.get())
    output = *path_;
  Polyline points;
  std::vector<Eigen::Vector3d> normals;
  points.reserve(output.size());
  normals.reserve(output.size());
  for (const ToolpathPoint& p : output) {
    points.push_back(p.getVector3fMap().cast<double>());
    normals.push_back(p.getNormalVector3fMap().cast<double>().normalized());
  }
  const ToolAxes result =
      toolAxes(points, normals, {tilt_angle_ * radians, lead_angle_ * radians, max_axis_rate_ * radians});
  for (std::size_t i = 0; i < output.size(); ++i)
    output[i].getAxisVector3fMap() = result.axes[i].cast<float>();
  largest_change_ = result.largest_change / radians;
  largest_rate_ = result.largest_rate / radians;
  largest_reduction_ = result.largest_reduction / radians;
  limited_points_ = result.limited_points;
  exceeded_moves_ = result.exceeded_moves;
}

} // namespace pcl_spiral
