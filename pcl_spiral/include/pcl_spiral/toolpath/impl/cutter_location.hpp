#pragma once

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/toolpath/cutter_location.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

template <typename PointT>
void
CutterLocation<PointT>::setDrivePath(const Path& path)
{
  drive_points_.clear();
  drive_points_.reserve(path.size());
  for (const ToolpathPoint& p : path)
    drive_points_.push_back({p.getVector3fMap().template cast<double>(),
                             p.getAxisVector3fMap().template cast<double>(),
                             p.getNormalVector3fMap().template cast<double>()});
  pass_sizes_ = {drive_points_.size()};
}

template <typename PointT>
void
CutterLocation<PointT>::setDrivePasses(const DrivePasses& passes)
{
  drive_points_.clear();
  pass_sizes_.clear();
  for (const DrivePass& pass : passes) {
    drive_points_.insert(drive_points_.end(), pass.points.begin(), pass.points.end());
    if (pass.closed && !pass.points.empty())
      drive_points_.push_back(pass.points.front());
    pass_sizes_.push_back(pass.points.size() + (pass.closed && !pass.points.empty()));
  }
}

template <typename PointT>
Status
CutterLocation<PointT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (const Status status = checkIndices(indices_.get(), input_->size()); !status.ok())
    return status;
  if (const std::string fault = faultOf(cutter_); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (!(options_.tolerance > 0.0) || !std::isfinite(options_.tolerance))
    return {StatusCode::InvalidArgument,
            textOf("the contact tolerance is ", options_.tolerance, " mm; set it above 0")};
  if (const std::string fault = faultOf(options_.holder); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (!(options_.holder_clearance >= 0.0) || !std::isfinite(options_.holder_clearance))
    return {StatusCode::InvalidArgument,
            textOf("the holder's clearance is ", options_.holder_clearance, " mm; set it to 0 or more")};
  if (!(options_.max_retilt >= 0.0) || !(options_.max_retilt <= 90.0))
    return {StatusCode::InvalidArgument,
            textOf("the largest retilt is ", options_.max_retilt, " degrees; set it between 0 and 90")};
  if (!(path_tolerance_ >= 0.0) || !std::isfinite(path_tolerance_))
    return {StatusCode::InvalidArgument,
            textOf("the path tolerance is ", path_tolerance_, " mm; set it above 0, or to 0 for none")};
  if (thread_count_ < 0)
    return {StatusCode::InvalidArgument,
            textOf("the number of threads is ", thread_count_, "; set 0 for all, or a count")};
  const bool asked = std::any_of(drive_points_.begin(), drive_points_.end(),
                                 [](const DrivePoint& p) { return p.normal.squaredNorm() > 0.0; });
  if (options_.max_retilt > 0.0 && !drive_points_.empty() && !asked)
    return {StatusCode::InvalidArgument,
            textOf("axes may turn by ", options_.max_retilt, " degrees for contacts to be reached, but no drive point "
                   "asks for one: give drive points their normals, or set the largest retilt to 0")};
  return checkDrivePoints(drive_points_);
}

template <typename PointT>
Status
CutterLocation<PointT>::run(std::vector<ToolLocations>& passes)
{
  if (const Status status = check(); !status.ok())
    return status;
  const ThreadLimit limit(thread_count_);
  surface_ = given_surface_;
  if (!surface_) {
    if (progress_ && !progress_(0.0, "surface"))
      return {StatusCode::Cancelled, "cancelled"};
    UsablePoints usable = usablePoints(*input_, indices_.get());
    if (usable.source.empty())
      return {StatusCode::InvalidInput, "no point of the cloud is finite; check the scan"};
    auto made = std::make_shared<ScannedLocationSurface>();
    made->surface.build(std::move(usable.positions));
    made->source = std::move(usable.source);
    surface_ = made;
  }
  const CutterLocator locator(surface_->surface, CutterProfile(cutter_), options_);
  const bool bisected = path_tolerance_ > 0.0;
  const auto inPart = [&](double begin, double end) { // progress of a part of the whole
    return ProgressCallback([this, begin, end](double share, const std::string& stage) {
      return !progress_ || progress_(begin + share * (end - begin), stage);
    });
  };
  ToolLocations locations;
  if (const Status status = locator.locate(drive_points_, inPart(0.0, bisected ? 0.5 : 1.0), locations); !status.ok())
    return status;
  std::vector<ToolLocations> located = inPasses(locations);
  if (bisected) {
    BisectionSettings settings;
    settings.tolerance = path_tolerance_;
    if (const Status status = bisectLocations(locator, settings, inPart(0.5, 1.0), located, bisection_figures_);
        !status.ok())
      return status;
    locations.clear();
    for (const ToolLocations& pass : located)
      locations.insert(locations.end(), pass.begin(), pass.end());
  }
  figures_ = locator.figures(locations);
  passes = std::move(located);
  for (ToolLocations& pass : passes)
    for (ToolLocation& location : pass)
      if (location.state != LocationState::NoCloud) {
        location.cloud_index = surface_->source[location.cloud_index];
        location.collision.cloud_index = surface_->source[location.collision.cloud_index];
      }
  return Status::success();
}

template <typename PointT>
std::vector<ToolLocations>
CutterLocation<PointT>::inPasses(const ToolLocations& locations) const
{
  std::vector<ToolLocations> passes;
  auto next = locations.begin();
  for (const std::size_t size : pass_sizes_) {
    passes.emplace_back(next, next + static_cast<std::ptrdiff_t>(size));
    next += static_cast<std::ptrdiff_t>(size);
  }
  return passes;
}

template <typename PointT>
void
CutterLocation<PointT>::compute(ToolLocations& locations)
{
  std::vector<ToolLocations> passes;
  compute(passes);
  locations.clear();
  for (const ToolLocations& pass : passes)
    locations.insert(locations.end(), pass.begin(), pass.end());
}

template <typename PointT>
void
CutterLocation<PointT>::compute(std::vector<ToolLocations>& passes)
{
  passes.clear();
  figures_ = LocationFigures();
  bisection_figures_ = BisectionFigures();
  surface_.reset();
  status_ = run(passes);
  if (!status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::CutterLocation::compute] %s.\n", status_.message().c_str());
}

} // namespace pcl_spiral
