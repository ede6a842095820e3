// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_ground.h"
#include "mesh_ground.h"
#include "tool_body.h"

#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t chunk = 8192; // drive points between two reports of progress

} // namespace

CutterLocationEngine::CutterLocationEngine(const LocationSurface& surface, const CutterProfile& profile, const LocationOptions& options)
: options_(options), profile_(profile), ground_(std::make_shared<CloudGround>(surface, profile, options))
{}

CutterLocationEngine::CutterLocationEngine(const LocationMesh& mesh, const CutterProfile& profile, const LocationOptions& options)
: options_(options), profile_(profile), ground_(std::make_shared<MeshGround>(mesh, profile, options))
{}

void
setCeilingAndLength(const CutterProfile& profile, const DrivePoints& drive, double asked, LocationOptions& options)
{
  constexpr double same_axis = 1e-9;
  const auto turns = [&](const DrivePoint& p) { return (p.axis.normalized() - drive.front().axis.normalized()).norm() > same_axis; };
  const bool may_end = !options.holder.empty() || std::any_of(drive.begin(), drive.end(), turns);
  if (options.holder.empty() && asked > 0.0)
    options.tool_length = asked; // its end is not known
  else if (may_end)
    options.tool_length = toolLength(profile, options.holder);
  options.ceiling = asked > 0.0 ? asked : options.tool_length;
}

double
CutterLocationEngine::moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const
{
  return ground_->moveError(from, to, allowed);
}

Status
CutterLocationEngine::locate(const DrivePoints& drive, const ProgressCallback& progress, ToolLocations& locations) const
{
  locations.clear();
  if (const Status status = ground_->check(); !status.ok())
    return status;
  locations.resize(drive.size());
  for (std::size_t begin = 0; begin < drive.size(); begin += chunk) {
    if (progress && !progress(static_cast<double>(begin) / static_cast<double>(drive.size()), "locations")) {
      locations.clear();
      return {StatusCode::Cancelled, "cancelled"};
    }
    const std::size_t count = std::min(chunk, drive.size() - begin);
    ground_->locate(&drive[begin], count, &locations[begin]);
    if (options_.max_retilt > 0.0 && options_.retilt_step == 0.0)
      retilt(&drive[begin], count, &locations[begin]);
  }
  return Status::success();
}

} // namespace pcl_spiral
