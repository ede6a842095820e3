// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_locations.h"
#include "scan_surface.h"

#include "cutter/tool_body.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

const char*
locationsWere(std::size_t count)
{
  return count == 1 ? " location was" : " locations were";
}

} // namespace

std::vector<ToolLocations>
locateCutter(const PassJob& job, const Surface::ConstPtr& surface, const DrivePasses& passes, ProgressBar& bar, PassResult& result)
{
  CutterLocation<pcl::PointXYZ> location;
  setPart(job, result, surface, location);
  location.setCutter(job.cutter);
  location.setHolder(job.holder);
  location.setHolderClearance(job.holder_clearance);
  location.setCeiling(job.ceiling);
  location.setMaxRetilt(job.max_retilt);
  location.setRetiltStep(job.retilt_step);
  location.setContactTolerance(std::min(location.getContactTolerance(), job.tolerance));
  location.setPathTolerance(job.tolerance);
  location.setDrivePasses(passes);
  location.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.5 + 0.5 * share, stage); });
  std::vector<ToolLocations> located;
  location.compute(located);
  require(job.part, location.getStatus());
  result.locations = location.getFigures();
  result.bisection = location.getBisectionFigures();
  return located;
}

void
requireNoCollision(const PassJob& job, const std::vector<ToolLocations>& located)
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
  if (!worst || job.program.accept_collisions)
    return;
  throw FileError(job.part, Diagnostic(nameOf(worst->collision, job.holder), " would be ", worst->collision.depth,
                                       " mm deep in the part at ", Place(worst->collision.place), ", the tip at ", Place(worst->tip),
                                       "; at ", count, " locations in total: use a longer or thinner tool, another axis, ",
                                       job.max_retilt > 0.0 ? "a larger --max-retilt" : "lean the axis by --max-retilt 30",
                                       ", or --accept-collisions to write the path anyway"));
}

void
requireKnownEnd(const PassJob& job, const std::vector<ToolLocations>& located)
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
  if (!under || job.ceiling > 0.0 || job.program.accept_collisions || (turns && !job.holder.empty()))
    return; // a warning says it
  const double length = toolLength(CutterProfile(job.cutter), job.holder);
  throw FileError(
      job.part,
      Diagnostic("at ", count, " locations the scan goes on above the end of the tool, first with the tip at ", Place(under->tip),
                 job.holder.empty() ? Diagnostic(", and the tool is taken as ", length, " mm long: give its shank and holder (--holder)")
                                    : Diagnostic(", ", length, " mm above the tip: what holds the tool would be in it"),
                 ", let the cutter be lifted over what is there (--ceiling 1000), or, if nothing of the tool is above, "
                 "say so (--ceiling ",
                 length, ")"));
}

void
takePoses(const std::vector<ToolLocations>& located, PassResult& result)
{
  for (const ToolLocations& pass : located) {
    ToolPoses poses;
    const auto close = [&] {
      if (poses.size() > 1)
        result.passes.push_back(poses);
      result.off_scan += poses.size() == 1;
      poses.clear();
    };
    for (const ToolLocation& location : pass) {
      if (location.state == LocationState::NoCloud) {
        ++result.off_scan;
        close();
        continue;
      }
      if (!poses.empty())
        result.length += (location.tip - poses.back().tip).norm();
      poses.push_back({location.tip, location.axis, location.contact, location.normal});
    }
    close();
  }
}

void
warnOfLocations(const PassJob& job, PassResult& result)
{
  Diagnostics& warnings = result.warnings;
  warnings.insert(warnings.end(), result.locations.warnings.begin(), result.locations.warnings.end());
  const LeftOutLocations& left = result.left_out;
  if (left.entering > 0)
    warnings.push_back(Diagnostic(left.entering, locationsWere(left.entering),
                                  " left out because the cutter would enter a keep-out there; passes are "
                                  "interrupted (--keep-out)"));
  if (left.touching > 0)
    warnings.push_back(Diagnostic(left.touching, locationsWere(left.touching), " left out because the tool would be up to ", left.deepest,
                                  " mm deep in what stands in a keep-out, first at ", Place(left.first),
                                  "; passes are interrupted (--keep-out)"));
  if (left.beside > 0)
    warnings.push_back(Diagnostic(left.beside, locationsWere(left.beside), " left out because the tool would be up to ",
                                  left.deepest_beside, " mm deep in the scan beside what is cut, first at ", Place(left.first_beside),
                                  "; passes are interrupted"));
  if (const std::size_t off = result.off_scan - std::min(result.off_scan, left.count()); off > 0)
    warnings.push_back(Diagnostic(off, off == 1 ? " location has" : " locations have", " no part of the surface below the cutter and ",
                                  off == 1 ? "was" : "were", " left out; passes are interrupted there"));
  if (result.bisection.unresolved > 0)
    warnings.push_back(Diagnostic(
        result.bisection.unresolved, result.bisection.unresolved == 1 ? " move exceeds the" : " moves exceed the tolerance of ",
        job.tolerance, " mm, the worst by an error of ", result.bisection.largest_error, " mm at ", Place(result.bisection.worst_place),
        ": the axis turns too fast or the surface is too steep there; check this place before you cut"));
}
