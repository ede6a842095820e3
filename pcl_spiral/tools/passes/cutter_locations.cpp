// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_locations.h"
#include "scan_surface.h"

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** Without a fit, the surface's normal is that of the cutter at the contact. */
Eigen::Vector3d
normalAt(const CutterProfile& cutter, const ToolLocation& location)
{
  if (location.normal.squaredNorm() > 0.5)
    return location.normal;
  const Eigen::Vector3d from_tip = location.contact - location.tip;
  const Eigen::Vector3d across = from_tip - from_tip.dot(location.axis) * location.axis;
  const double l = std::min(across.norm(), cutter.radius());
  const Eigen::Vector2d out = cutter.normal(l);
  const Eigen::Vector3d side = l > 0.0 ? Eigen::Vector3d(across.normalized()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  return -(out.x() * side + out.y() * location.axis).normalized();
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
requireNoCollision(const PassJob& job, const std::vector<ToolLocations>& located, const LocationFigures& figures)
{
  if (figures.collisions == 0 || job.program.accept_collisions)
    return;
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.collision.found() && location.collision.depth >= figures.deepest_collision)
        throw FileError(job.part, textOf(job.holder[static_cast<std::size_t>(location.collision.segment)].name, " would be ",
                                         location.collision.depth, " mm deep in the part at ", placeText(location.collision.place),
                                         ", the tip at ", placeText(location.tip), "; at ", figures.collisions,
                                         " locations in total: use a longer or thinner tool, another axis, or "
                                         "--accept-collisions to write the path anyway"));
}

void
leaveKeepOuts(const PassJob& job, std::vector<ToolLocations>& located, PassResult& result)
{
  const CutterProfile cutter(job.cutter);
  const auto low = [&](const ToolLocation& l) -> Eigen::Vector3d { return l.tip + cutter.cornerRadius() * l.axis; };
  const auto high = [&](const ToolLocation& l) -> Eigen::Vector3d { return low(l) + job.cutter.flank_length * l.axis; };
  const auto enters = [&](const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    return std::any_of(result.chosen.keep_outs.begin(), result.chosen.keep_outs.end(),
                       [&](const Prism& prism) { return prism.distance(begin, end) < cutter.radius(); });
  };
  for (ToolLocations& pass : located) {
    const ToolLocation* before = nullptr;
    for (ToolLocation& l : pass) {
      if (l.state == LocationState::NoCloud || result.chosen.keep_outs.empty())
        continue;
      const bool moves_in = before && (enters(low(*before), low(l)) || enters(high(*before), high(l)));
      before = nullptr;
      if (moves_in || enters(low(l), high(l))) {
        l.state = LocationState::NoCloud;
        ++result.kept_out;
      }
      else
        before = &l;
    }
  }
}

void
takePoses(const CutterProfile& cutter, const std::vector<ToolLocations>& located, PassResult& result)
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
      poses.push_back({location.tip, location.axis, location.contact, normalAt(cutter, location)});
    }
    close();
  }
}

void
warnOfLocations(const PassJob& job, PassResult& result)
{
  std::vector<std::string>& warnings = result.warnings;
  warnings.insert(warnings.end(), result.locations.warnings.begin(), result.locations.warnings.end());
  if (result.kept_out > 0)
    warnings.push_back(textOf(result.kept_out, " locations were left out because the cutter would enter a keep-out there; passes are "
                                               "interrupted (--keep-out)"));
  if (result.off_scan > result.kept_out)
    warnings.push_back(textOf(result.off_scan - result.kept_out,
                              " locations have no part of the surface below the cutter and were left out; passes are interrupted there"));
  if (result.bisection.unresolved > 0)
    warnings.push_back(textOf(result.bisection.unresolved, " moves exceed the tolerance of ", job.tolerance,
                              " mm, the worst by an error of ", result.bisection.largest_error, " mm at ",
                              placeText(result.bisection.worst_place),
                              ": the axis turns too fast or the surface is too steep there; check this place before you cut"));
}
