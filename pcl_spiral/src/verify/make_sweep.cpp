// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {
namespace {

/** Places the cutter at its contacts. */
Status
tipsAt(const CutterPath& path, const CutterShape& cutter, Polyline& tips)
{
  const CutterProfile profile(cutter);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const CutterContact contact = profile.locate(path.contacts[i], path.normals[i], path.axes[i]);
    if (!contact.touches)
      return {
          StatusCode::InvalidInput,
          Diagnostic("at path point ", i, ", ", Place(path.contacts[i]), ", the surface leans over the flank of this cutter by ",
                     contact.excess_angle,
                     " {degrees}: it cannot touch there; give the cutter of the path ({setCutter}), or its tool tips ({setInputTips})")};
    tips.push_back(contact.tip);
  }
  return Status::success();
}

} // namespace

bool
isBall(const CutterShape& cutter)
{
  return cutter.corner_radius == cutter.radius && cutter.flank_length == 0.0 && cutter.flank_angle == 0.0;
}

Status
makeSweep(const CutterPath& path, const CutterShape& cutter, const Polyline& tips, std::unique_ptr<CutterSweep>& sweep)
{
  sweep.reset();
  if (!tips.empty() && tips.size() != path.size())
    return {StatusCode::InvalidInput,
            Diagnostic(tips.size(), " tool tips are given for ", path.size(), " path points; give one for each ({setInputTips})")};
  if (isBall(cutter)) {
    sweep = std::make_unique<BallSweep>(path.contacts, path.normals, cutter.radius, path.passes);
    return Status::success();
  }
  if (const Diagnostic fault = faultOf(cutter); !fault.empty())
    return {StatusCode::InvalidArgument, Diagnostic("the cutter ({setCutter}): ", fault)};
  if (path.axes.empty())
    return {StatusCode::InvalidInput,
            "the path has points without a tool axis: only for a ball is the place of the cutter known without it"};
  Polyline placed = tips;
  if (placed.empty())
    if (const Status status = tipsAt(path, cutter, placed); !status.ok())
      return status;
  sweep = std::make_unique<ProfileSweep>(cutter, std::move(placed), path.axes, path.passes);
  return Status::success();
}

RemovalSettings
removalSettings(const CutterShape& cutter, double scallop_height, double chord_error, double reach)
{
  RemovalSettings settings;
  settings.tool_radius = cutter.radius;
  settings.scallop_height = scallop_height;
  settings.chord_error = chord_error;
  settings.reach = reach;
  if (isBall(cutter) || !(scallop_height > 0.0) || !faultOf(cutter).empty())
    return settings;
  const double step = stepForScallop(CutterProfile(cutter), scallop_height).value_or(0.0);
  if (step > 0.0)
    settings.step_radius = (0.25 * step * step + scallop_height * scallop_height) / (2.0 * scallop_height);
  settings.corner_radius = cutter.corner_radius;
  return settings;
}

} // namespace pcl_spiral
