// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {

template <typename PointT>
void
CutterLocation<PointT>::setDrivePath(const Path& path)
{
  drive_points_.clear();
  drive_points_.reserve(path.size());
  for (const ToolpathPoint& p : path)
    drive_points_.push_back({p.getVector3fMap().template cast<double>(), p.getAxisVector3fMap().template cast<double>(),
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
  if (const Diagnostic fault = faultOf(cutter_); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (!(options_.tolerance > 0.0) || !std::isfinite(options_.tolerance))
    return {StatusCode::InvalidArgument, Diagnostic("the contact tolerance is ", options_.tolerance, " {mm}; set it above 0")};
  if (const Diagnostic fault = faultOf(options_.holder); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (!(options_.holder_clearance >= 0.0) || !std::isfinite(options_.holder_clearance))
    return {StatusCode::InvalidArgument, Diagnostic("the holder's clearance is ", options_.holder_clearance, " {mm}; set it to 0 or more")};
  if (const CutterProfile profile(cutter_); !(ceiling_ == 0.0 || ceiling_ >= profile.topHeight()))
    return {StatusCode::InvalidArgument,
            Diagnostic("the ceiling is ", ceiling_, " {mm} above the drive points, but the cutter is ", profile.topHeight(),
                       " {mm} high; set it above that, or to 0 for the length of the tool ({setCeiling})")};
  if (!(options_.max_retilt >= 0.0) || !(options_.max_retilt <= 90.0))
    return {StatusCode::InvalidArgument, Diagnostic("the largest retilt is ", options_.max_retilt, " {degrees}; set it between 0 and 90")};
  if (!(options_.retilt_step >= 0.0) || !(options_.retilt_step <= 180.0))
    return {StatusCode::InvalidArgument, Diagnostic("the largest retilt from one location to the next is ", options_.retilt_step,
                                                    " {degrees}; set it between 0 and 180")};
  if (!(path_tolerance_ >= 0.0) || !std::isfinite(path_tolerance_))
    return {StatusCode::InvalidArgument, Diagnostic("the path tolerance is ", path_tolerance_, " {mm}; set it above 0, or to 0 for none")};
  const bool asked =
      std::any_of(drive_points_.begin(), drive_points_.end(), [](const DrivePoint& p) { return p.normal.squaredNorm() > 0.0; });
  if (options_.max_retilt > 0.0 && options_.retilt_step == 0.0 && !drive_points_.empty() && !asked)
    return {StatusCode::InvalidArgument,
            Diagnostic("axes may turn by ", options_.max_retilt,
                       " {degrees} for contacts to be reached, but no drive point "
                       "asks for one: give drive points their normals, limit the change of the turn along passes "
                       "({setRetiltStep}), or set the largest retilt to 0")};
  return checkDrivePoints(drive_points_);
}

template <typename PointT>
LocationOptions
CutterLocation<PointT>::optionsWithCeiling() const
{
  LocationOptions options = options_;
  setCeilingAndLength(CutterProfile(cutter_), drive_points_, ceiling_, options);
  return options;
}

template <typename PointT>
Status
CutterLocation<PointT>::makeLocationSurface()
{
  location_surface_ = given_location_;
  if (location_surface_)
    return Status::success();
  if (progress_ && !progress_(0.0, "surface"))
    return {StatusCode::Cancelled, "cancelled"};
  Surface::ConstPtr surface;
  if (const Status status = this->checkInput(); !status.ok())
    return status;
  const Status made = this->prepareSurface(surface);
  if (made.code() == StatusCode::InvalidArgument || made.code() == StatusCode::Cancelled)
    return made; // a setting is wrong; if only the points form no surface, cutters still stay off them
  if (surface)
    if (const Status status = this->checkMeasured(*surface, "where nothing is known"); !status.ok())
      return status;
  if (this->given_surface_) {
    if (made.ok())
      location_surface_ = std::make_shared<LocationSurface>(surface);
    return made;
  }
  UsablePoints usable = usablePoints(*this->input_, this->givenIndices().get());
  if (usable.source.empty())
    return made;
  location_surface_ = std::make_shared<LocationSurface>(std::move(usable.positions), std::move(usable.source), std::move(surface), made);
  return Status::success();
}

template <typename PointT>
Status
CutterLocation<PointT>::checkBesideMesh() const
{
  if (given_location_)
    return {StatusCode::InvalidArgument, "{setLocationSurface} was called beside {setInputMesh}, whose surface is its own: leave it out"};
  if (const Status status = pcl_spiral::checkBesideMesh(this->surfaceSettings(), this->scanned_.getInputNormals() != nullptr,
                                                        this->givenIndices() != nullptr);
      !status.ok())
    return status;
  return checkThreads(this->getNumberOfThreads());
}

template <typename PointT>
Status
CutterLocation<PointT>::makeLocationMesh()
{
  if (const Status status = checkBesideMesh(); !status.ok())
    return status;
  if (location_mesh_)
    return Status::success();
  if (progress_ && !progress_(0.0, "surface"))
    return {StatusCode::Cancelled, "cancelled"};
  if (const Status status = this->prepareMesh(MeshSettings()); !status.ok())
    return status;
  location_mesh_ = std::make_shared<LocationMesh>(this->mesh_);
  return Status::success();
}

template <typename PointT>
Status
CutterLocation<PointT>::run(std::vector<ToolLocations>& passes)
{
  const ThreadLimit limit(this->getNumberOfThreads());
  if (const Status status = check(); !status.ok())
    return status;
  if (const Status status = this->on_mesh_ ? makeLocationMesh() : makeLocationSurface(); !status.ok())
    return status;
  const CutterProfile profile(cutter_);
  const LocationOptions options = optionsWithCeiling();
  return locate(this->on_mesh_ ? CutterLocationEngine(*location_mesh_, profile, options)
                               : CutterLocationEngine(*location_surface_, profile, options),
                passes);
}

template <typename PointT>
Status
CutterLocation<PointT>::locate(const CutterLocationEngine& locator, std::vector<ToolLocations>& passes)
{
  constexpr double margins[] = {0.1, 0.5, 2.0}; // mm between holder and scan at the drive points, for what is between them
  const double share = path_tolerance_ > 0.0 ? 0.5 : 1.0;
  ToolLocations locations;
  if (const Status status = locator.locate(drive_points_, partOf(progress_, 0.0, share), locations); !status.ok())
    return status;
  const bool turns = options_.max_retilt > 0.0 && options_.retilt_step > 0.0;
  for (const double margin : margins) {
    std::vector<ToolLocations> located = inPasses(locations);
    BisectionReport bisection;
    if (const Status status = turns ? retilt(locator, margin, located) : Status::success(); !status.ok())
      return status;
    if (const Status status = bisect(locator, located, bisection); !status.ok())
      return status;
    ToolLocations all;
    for (const ToolLocations& pass : located)
      all.insert(all.end(), pass.begin(), pass.end());
    LocationReport figures = locator.figures(all);
    if (passes.empty() || figures.collisions < figures_.collisions) {
      passes = std::move(located);
      figures_ = std::move(figures);
      bisection_figures_ = bisection;
    }
    if (!turns || figures_.collisions == 0)
      break;
  }
  return Status::success();
}

/** Turns axes along each pass. */
template <typename PointT>
Status
CutterLocation<PointT>::retilt(const CutterLocationEngine& locator, double margin, std::vector<ToolLocations>& passes) const
{
  std::size_t first = 0;
  for (ToolLocations& pass : passes) {
    if (progress_ && !progress_(path_tolerance_ > 0.0 ? 0.5 : 1.0, "axes"))
      return {StatusCode::Cancelled, "cancelled"};
    locator.retiltPass(&drive_points_[first], margin, pass.size(), pass.data());
    first += pass.size();
  }
  return Status::success();
}

/** Adds locations between those of \p passes, if there is a tolerance. */
template <typename PointT>
Status
CutterLocation<PointT>::bisect(const CutterLocationEngine& locator, std::vector<ToolLocations>& passes, BisectionReport& figures) const
{
  if (path_tolerance_ == 0.0)
    return Status::success();
  BisectionSettings settings;
  settings.tolerance = path_tolerance_;
  return bisectLocations(locator, settings, partOf(progress_, 0.5, 1.0), passes, figures);
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
  locations.clear();
  std::vector<ToolLocations> passes;
  compute(passes);
  for (const ToolLocations& pass : passes)
    locations.insert(locations.end(), pass.begin(), pass.end());
}

template <typename PointT>
void
CutterLocation<PointT>::compute(std::vector<ToolLocations>& passes)
{
  passes.clear();
  figures_ = LocationReport();
  bisection_figures_ = BisectionReport();
  location_surface_.reset();
  std::vector<ToolLocations> made;
  if (this->computeBy("CutterLocation", [&] { return run(made); }))
    passes = std::move(made);
}

} // namespace pcl_spiral
