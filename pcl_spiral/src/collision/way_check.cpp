// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/collision/impl/way_check.h>

#include "ball_way.h"
#include "things_in_the_way.h"
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/tool_holder.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double link = 3.0;               // spacings: between points of one thing
constexpr double more = 2.0, least = 0.25; // times the depth, spacings: farther away, the outline is another one
constexpr double beyond = 1.5;             // spacings: how far a path may run beyond the last points

using Path = pcl::PointCloud<ToolpathPoint>;

/** The path with the tool upright on the surface. */
Path
upright(const Path& path)
{
  Path other = path;
  for (ToolpathPoint& p : other)
    p.getAxisVector3fMap() = p.getNormalVector3fMap();
  return other;
}

/** The remedy of less tilt, if \p tool has a tilt and \p isFree holds for the upright tool. */
template <typename IsFree>
Diagnostic
lessTilt(const Path& path, const WayTool& tool, IsFree isFree)
{
  if ((!tool.tilted && !tool.led) || !isFree(upright(path)))
    return "";
  const char* setters = !tool.led ? "{setTiltAngle}" : !tool.tilted ? "{setLeadAngle}" : "{setTiltAngle}, {setLeadAngle}";
  return Diagnostic(", or tilt the tool less (", setters, "): upright, it hits nothing");
}

/** What may help, with what is in the way. */
Diagnostic
remedyOf(const std::vector<ThingInTheWay>& things, bool of_mesh)
{
  return thingsText(things, !of_mesh) + (of_mesh ? ": take a smaller tool ({setToolRadius}), or leave that part out of the mesh"
                                                 : ": keep out of each with a polygon that covers it ({addKeepOut})");
}

/** What may help where a polygon would cover too much. */
Diagnostic
otherRemedies(const std::vector<ThingInTheWay>& things, bool of_mesh)
{
  if (of_mesh || std::none_of(things.begin(), things.end(), [](const ThingInTheWay& thing) { return thing.around; }))
    return "";
  return ". What is all round the path is often the table: crop the scan inside the rim of the part ({setCrop})";
}

/** Whether \p path has contacts on the part itself, not over a gap of it, in one of \p keep_outs. */
bool
cutsPartIn(const std::vector<Prism>& keep_outs, const Path& path)
{
  return std::any_of(path.begin(), path.end(), [&](const ToolpathPoint& p) {
    return p.over_gap == 0 && std::any_of(keep_outs.begin(), keep_outs.end(),
                                          [&p](const Prism& prism) { return prism.contains(p.getVector3fMap().cast<double>()); });
  });
}

/** Refuses a ball that enters a keep-out, and a shank that cuts into what stands there. */
Status
checkKeepOuts(const Path& path, const WayTool& tool, const Surroundings& around, std::optional<BlockedWay>& blocked)
{
  if (const auto entry = deepestEntry(path, ballCentres(path, tool.radius), tool.radius, around.keep_outs)) {
    blocked = BlockedWay{BlockedBy::KeepOut, std::max(more * entry->depth, least * tool.spacing), entry->depth > beyond * tool.spacing};
    const bool cuts_part = cutsPartIn(around.keep_outs, path);
    const Diagnostic depth = cuts_part ? Diagnostic(entry->depth) : Diagnostic(Proposed("addKeepOut", entry->depth));
    const Diagnostic fault("the ball enters a keep-out by ", depth, " {mm} at ", Place(entry->place));
    if (cuts_part)
      return {StatusCode::InvalidInput, Diagnostic(fault, ": points of the part are in the keep-out; leave them out: {PartRegion} "
                                                          "gives the indices of those that can be cut")};
    return {StatusCode::Failed, Diagnostic(fault, ": enlarge the polygon there by that much ({addKeepOut})")};
  }
  const auto deepest = [&](const Path& any) { return deepestPoint(any, tool.radius, around.kept_out); };
  const auto isFree = [&](const Path& any) {
    const auto cut = deepest(any);
    return !cut || cut->depth <= tool.allowed;
  };
  if (isFree(path))
    return Status::success();
  const BallEntry cut = *deepest(path);
  blocked = BlockedWay{BlockedBy::KeptOut, 0.0, false};
  return {StatusCode::Failed, Diagnostic("the shank, taken as ", shank_radii, " radii long, would cut ", Proposed("addKeepOut", cut.depth),
                                         " {mm} into what stands in a keep-out, at ", Place(cut.place),
                                         ": enlarge the polygon there by that much ({addKeepOut})", lessTilt(path, tool, isFree))};
}

/** Refuses what is in the way beside the part, and warns of single points there. */
Status
checkBeside(const Path& path, const WayTool& tool, const Surroundings& around, std::optional<BlockedWay>& blocked, Diagnostics& warnings)
{
  const auto with = [](std::vector<Eigen::Vector3f> some, const std::vector<Eigen::Vector3f>& more_points) {
    some.insert(some.end(), more_points.begin(), more_points.end());
    return some;
  };
  const auto inTheWay = [&](const Path& any, const std::vector<Eigen::Vector3f>& points) {
    return thingsInTheWay(any, tool.radius, points, tool.allowed, link * tool.spacing);
  };
  std::vector<Eigen::Vector3f> points = with(around.beside, around.standing);
  std::vector<ThingInTheWay> things = inTheWay(path, points);
  if (things.empty())
    return Status::success();
  if (!around.beside.empty() && around.scan) {
    points = with(withoutEchoes(around.beside, *around.scan), around.standing);
    const Eigen::Vector3d deepest = things.front().place;
    things = inTheWay(path, points);
    if (things.empty()) {
      warnings.push_back(Diagnostic("the ball or its shank cuts into the {scan} at ", Place(deepest),
                                    ", beside what is cut: only single points off the surface are there, usually false echoes"));
      return Status::success();
    }
  }
  const auto isFree = [&](const Path& any) { return inTheWay(any, points).empty(); };
  blocked = BlockedWay{BlockedBy::Beside, 0.0, false};
  return {StatusCode::Failed,
          Diagnostic("the ball or its shank, taken as ", shank_radii, " radii long, would cut ", things.front().depth, " {mm} into the ",
                     around.of_mesh ? "mesh" : "scan", " at ", Place(things.front().place), ", beside what is cut. ",
                     remedyOf(things, around.of_mesh), lessTilt(path, tool, isFree), otherRemedies(things, around.of_mesh))};
}

} // namespace

double
holeSizeBeside(double hole_size, const std::vector<Prism>& keep_outs, double radius)
{
  constexpr double share = 0.7; // of the polygon and the ball beside it: on slopes the ball needs less room on one side
  for (const Prism& prism : keep_outs)
    if (const double left = share * (prism.width() + 2.0 * radius); hole_size == 0.0 || left < hole_size)
      hole_size = left;
  return hole_size;
}

Status
checkWay(const Path& path, const WayTool& tool, const Surroundings& around, std::optional<BlockedWay>& blocked, Diagnostics& warnings)
{
  blocked.reset();
  if (const Status status = checkKeepOuts(path, tool, around, blocked); !status.ok())
    return status;
  return checkBeside(path, tool, around, blocked, warnings);
}

} // namespace pcl_spiral
