// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pass_locations.h"

#include "planning/field_names.h"
#include "planning/tool_way.h"

#include "cutter/tool_body.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/cutter_location.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

const char*
locationsWere(std::size_t count)
{
  return count == 1 ? " location was" : " locations were";
}

} // namespace

LedTool
toolOf(const PassSettings& settings, const PassPlan& plan)
{
  return {settings.cutter,  settings.holder,           settings.holder_clearance, settings.tolerance + plan.locations.noise_allowance,
          settings.threads, settings.accept_collisions};
}

Status
locateCutter(const PassSettings& settings, const SurfaceSettings& surface, const DrivePasses& passes, const ProgressCallback& progress,
             PassPlan& plan, std::vector<ToolLocations>& located)
{
  CutterLocation<pcl::PointXYZ> location;
  setPart(plan, surface, location);
  location.setCutter(settings.cutter);
  location.setHolder(settings.holder);
  location.setHolderClearance(settings.holder_clearance);
  location.setCeiling(settings.ceiling);
  location.setMaxRetilt(settings.max_retilt);
  location.setRetiltStep(settings.retilt_step);
  location.setContactTolerance(std::min(location.getContactTolerance(), settings.tolerance));
  location.setPathTolerance(settings.tolerance);
  location.setDrivePasses(passes);
  location.setProgressCallback(progress);
  location.setQuiet(true);
  location.compute(located);
  plan.locations = location.getReport();
  plan.bisection = location.getBisectionReport();
  return renamed(location.getStatus(), location_names);
}

namespace {

/** Failed with the deepest place if shank or holder are in the part at a location, unless that is accepted. */
Status
checkCollisions(const PassSettings& settings, const std::vector<ToolLocations>& located)
{
  const ToolLocation* worst = nullptr;
  std::size_t count = 0;
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass) {
      if (location.state == LocationState::NoCloud || !location.collision.found())
        continue;
      ++count;
      if (!worst || location.collision.depth > worst->collision.depth)
        worst = &location;
    }
  if (!worst || settings.accept_collisions)
    return Status::success();
  return {StatusCode::Failed,
          Diagnostic(nameOf(worst->collision, settings.holder), " would be ", worst->collision.depth, " {mm} deep in the part at ",
                     Place(worst->collision.place), ", the tip at ", Place(worst->tip), "; at ", count,
                     " locations in total: use a longer or thinner tool, another axis, ",
                     settings.max_retilt > 0.0 ? "a larger {PassSettings::max_retilt}" : "lean the axis by {PassSettings::max_retilt} 30",
                     ", or {setAcceptCollisions} to write the path anyway")};
}

/** Failed if the scan goes on above the end of the tool, and nothing says how long the tool is or from where it comes. */
Status
checkEnd(const PassSettings& settings, const std::vector<ToolLocations>& located)
{
  constexpr double same_axis = 1e-9;
  const ToolLocation *first = nullptr, *under = nullptr;
  std::size_t count = 0;
  bool turns = false;
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass) {
      if (location.state == LocationState::NoCloud)
        continue;
      first = first ? first : &location;
      turns = turns || (location.axis - first->axis).norm() > same_axis;
      count += location.under_scan;
      under = !under && location.under_scan ? &location : under;
    }
  if (!under || settings.ceiling > 0.0 || settings.accept_collisions || (turns && !settings.holder.empty()))
    return Status::success(); // a warning says it
  const double length = toolLength(CutterProfile(settings.cutter), settings.holder);
  return {StatusCode::Failed,
          Diagnostic("at ", count, " locations the scan goes on above the end of the tool, first with the tip at ", Place(under->tip),
                     settings.holder.empty()
                         ? Diagnostic(", and the tool is taken as ", length, " {mm} long: give its shank and holder ({setHolder})")
                         : Diagnostic(", ", length, " {mm} above the tip: what holds the tool would be in it"),
                     ", let the cutter be lifted over what is there ({PassSettings::ceiling} 1000), or, if nothing of the tool is above, "
                     "say so ({PassSettings::ceiling} ",
                     length, ")")};
}

/** Passes without the locations that are off the part; a pass of one location is none. */
void
takePoses(const std::vector<ToolLocations>& located, PassPlan& plan)
{
  for (const ToolLocations& pass : located) {
    ToolPoses poses;
    const auto close = [&] {
      if (poses.size() > 1)
        plan.passes.push_back(poses);
      plan.off_scan += poses.size() == 1;
      poses.clear();
    };
    for (const ToolLocation& location : pass) {
      if (location.state == LocationState::NoCloud) {
        ++plan.off_scan;
        close();
        continue;
      }
      if (!poses.empty())
        plan.length += (location.tip - poses.back().tip).norm();
      poses.push_back({location.tip, location.axis, location.contact, location.normal});
    }
    close();
  }
}

} // namespace

Status
takeChecked(const PassSettings& settings, const std::vector<ToolLocations>& located, const Diagnostic& none, PassPlan& plan)
{
  for (const auto& check : {checkCollisions, checkEnd})
    if (const Status status = check(settings, located); !status.ok())
      return status;
  takePoses(located, plan);
  if (plan.passes.empty())
    return {StatusCode::Failed, none};
  return settings.holder.empty() ? Status::success() : checkToolWay(wayOf(plan), plan.passes, plan.warnings);
}

void
warnOfLocations(const PassSettings& settings, PassPlan& plan)
{
  Diagnostics& warnings = plan.warnings;
  warnings.insert(warnings.end(), plan.locations.warnings.begin(), plan.locations.warnings.end());
  const LeftOutLocations& left = plan.left_out;
  if (left.entering > 0)
    warnings.push_back(Diagnostic(left.entering, locationsWere(left.entering),
                                  " left out because the cutter would enter a keep-out there; passes are "
                                  "interrupted ({addKeepOut})"));
  if (left.touching > 0)
    warnings.push_back(Diagnostic(left.touching, locationsWere(left.touching), " left out because the tool would be up to ", left.deepest,
                                  " {mm} deep in what stands in a keep-out, first at ", Place(left.first),
                                  "; passes are interrupted ({addKeepOut})"));
  if (left.beside > 0)
    warnings.push_back(Diagnostic(left.beside, locationsWere(left.beside), " left out because the tool would be up to ",
                                  left.deepest_beside, " {mm} deep in the scan beside what is cut, first at ", Place(left.first_beside),
                                  "; passes are interrupted"));
  if (const std::size_t off = plan.off_scan - std::min(plan.off_scan, left.count()); off > 0)
    warnings.push_back(Diagnostic(off, off == 1 ? " location has" : " locations have", " no part of the surface below the cutter and ",
                                  off == 1 ? "was" : "were", " left out; passes are interrupted there"));
  if (plan.bisection.unresolved > 0)
    warnings.push_back(Diagnostic(
        plan.bisection.unresolved, plan.bisection.unresolved == 1 ? " move exceeds the tolerance of " : " moves exceed the tolerance of ",
        settings.tolerance, " {mm}, the worst by an error of ", plan.bisection.largest_error, " {mm} at ",
        Place(plan.bisection.worst_place), ": the axis turns too fast or the surface is too steep there; check this place before you cut"));
}

std::vector<ToolLocations>
standAtContacts(const PassSettings& settings, const DrivePasses& passes)
{
  const CutterProfile cutter(settings.cutter);
  std::vector<ToolLocations> located;
  for (const DrivePass& pass : passes) {
    located.emplace_back();
    const auto add = [&](const DrivePoint& p) {
      ToolLocation location;
      location.axis = p.axis.normalized();
      location.tip = cutter.locate(p.position, p.normal, location.axis).tip;
      location.contact = p.position;
      location.normal = p.normal;
      location.state = LocationState::Reached;
      location.basis = LocationBasis::AskedContact;
      located.back().push_back(location);
    };
    std::for_each(pass.points.begin(), pass.points.end(), add);
    if (pass.closed)
      add(pass.points.front());
  }
  return located;
}

} // namespace pcl_spiral
