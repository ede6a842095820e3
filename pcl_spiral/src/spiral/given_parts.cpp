// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/given_parts.h>

#include "core/angle_between.h"
#include "spiral/field/scallop_size.h"
#include "spiral/path/given_path.h"
#include "spiral/path/path_feet.h"

#include "common/stoppable_loop.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double known_outline = 1.25;  // spacings: an outline is known to one, and is compared with points half of one apart
constexpr double most_turns = 1u << 24; // a float tells no two turns apart above that

Status
invalid(Diagnostic message)
{
  return {StatusCode::InvalidArgument, std::move(message)};
}

/** Ok, or an error if passes do not begin in order, or have one point, in a path of \p size points. */
Status
checkPasses(const std::vector<std::size_t>& passes, std::size_t size, const Diagnostic& what)
{
  std::size_t before = 0;
  for (const std::size_t begin : passes) {
    if (begin < before + 2 || begin + 2 > size)
      return invalid(
          Diagnostic(what, " has a pass that begins at point ", begin, " behind one that begins at point ", before, ", of ", size,
                     " points: give the first points of the second and each later pass in their order, and two points or more for "
                     "each pass"));
    before = begin;
  }
  return size < 2 ? invalid(Diagnostic(what, " has one point: give two or more")) : Status::success();
}

/** Ok, or an error if \p path cannot be sampled. Turns that are not given are 0. */
Status
checkLinked(LinkedPath& path, const Diagnostic& what)
{
  const std::size_t n = path.points.size();
  if (n == 0)
    return {StatusCode::InvalidInput, Diagnostic(what, " has no points: look at what made it, or take it back")};
  if (path.turns.empty())
    path.turns.assign(n, 0.0f);
  if (path.turns.size() != n)
    return invalid(Diagnostic(what, " has ", n, " points and ", path.turns.size(), " turns: give one for each point, or none"));
  for (std::size_t i = 0; i < n; ++i)
    if (!path.points[i].allFinite() || !(std::abs(path.turns[i]) < most_turns))
      return invalid(Diagnostic("point ", i, " of ", what, " is ", Place(path.points[i]), " in turn ", path.turns[i],
                                ": remove it, or give finite numbers"));
  return checkPasses(path.passes, n, what);
}

LinkedPath
linked(const std::vector<SpiralPoint>& curve)
{
  LinkedPath path;
  for (const SpiralPoint& point : curve) {
    if (point.begins_pass && !path.points.empty())
      path.passes.push_back(path.points.size());
    path.points.push_back(point.position);
    path.turns.push_back(static_cast<float>(point.turn));
  }
  return path;
}

/** \p path with points no farther apart than a spacing within a pass: between two of them the surface may bend. */
Status
closer(const LinkedPath& path, double spacing, LinkedPath& close)
{
  double count = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    count += std::ceil((path.points[i] - path.points[i - 1]).norm() / spacing);
  if (!(count < most_path_points))
    return invalid(Diagnostic("the curve needs ", count, " points to follow the surface, more than ", most_path_points,
                              ": is it in the unit of the {scan}, {mm}?"));
  close = LinkedPath();
  close.basis = path.basis;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const bool begins = beginsPass(path.passes, i);
    if (begins)
      close.passes.push_back(close.points.size());
    const int parts =
        i == 0 || begins ? 1 : std::max(1, static_cast<int>(std::ceil((path.points[i] - path.points[i - 1]).norm() / spacing)));
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      close.points.push_back(parts == 1 ? path.points[i] : Vector3d((1.0 - t) * path.points[i - 1] + t * path.points[i]));
      close.turns.push_back(parts == 1 ? path.turns[i] : static_cast<float>((1.0 - t) * path.turns[i - 1] + t * path.turns[i]));
    }
  }
  return Status::success();
}

/** Puts the points of the user's own \p path on the surface, closer together if they are far apart. */
Status
follow(const Surface& surface, LinkedPath& path)
{
  LinkedPath close;
  if (const Status status = closer(path, surface.spacing(), close); !status.ok())
    return status;
  path = std::move(close);
  Polyline queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < path.points.size(); begin += report_chunk) {
    const std::size_t end = std::min(path.points.size(), begin + report_chunk);
    queries.assign(path.points.begin() + static_cast<std::ptrdiff_t>(begin), path.points.begin() + static_cast<std::ptrdiff_t>(end));
    pathFeet(surface, queries, feet);
    for (std::size_t i = begin; i < end; ++i) {
      if (!feet[i - begin].valid)
        return {StatusCode::Failed, Diagnostic("the curve is off the {scanned surface} at ", Place(path.points[i]),
                                               ": move it onto the surface, or begin a pass behind that place, where the tool is lifted")};
      path.points[i] = feet[i - begin].position;
    }
  }
  double length = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    length += (path.points[i] - path.points[i - 1]).norm();
  return length > 0.0 ? Status::success() : invalid("the curve has no length: give points that differ");
}

/** The points of \p lines, which are closed, and more between them, at most \p step apart. */
std::vector<Eigen::Vector3f>
pointsOn(const std::vector<Polyline>& lines, double step)
{
  std::vector<Eigen::Vector3f> points;
  for (const Polyline& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vector3d &a = line[i], &b = line[(i + 1) % line.size()];
      const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
      for (int k = 0; k < parts; ++k)
        points.push_back((a + (b - a) * k / parts).cast<float>());
    }
  return points;
}

/** Ok, or an error if a point of \p path lies in a hole among \p boundaries, farther from its edge than the edge is known. */
Status
checkHoles(const LinkedPath& path, const std::vector<BoundaryLoop>& boundaries, double spacing)
{
  for (const BoundaryLoop& loop : boundaries) {
    if (loop.type != LoopType::Inner)
      continue;
    const Prism prism(loop.curve, polygonArea(loop.curve));
    if (!prism.fault().empty())
      continue;
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : loop.curve)
      box.extend(p);
    const double near = 0.5 * prism.width();
    const PointBlocks edge(pointsOn({loop.curve}, 0.5 * spacing));
    for (const Vector3d& p : path.points) {
      if (box.exteriorDistance(p) > near || !prism.contains(p))
        continue;
      if ((edge.position(edge.nearest(p)) - p).norm() > known_outline * spacing)
        return {StatusCode::Failed, Diagnostic("the path runs into a hole of the part, or nearer to it than its margin, at ", Place(p),
                                               ": lead it round the hole, or set the path to run over holes ({setHoleHandling})")};
    }
  }
  return Status::success();
}

/** Ok, or an error if \p rims, on which \p what was made, are not the \p boundaries. */
Status
checkRims(const std::vector<Polyline>& rims, const std::vector<BoundaryLoop>& boundaries, double spacing, const Diagnostic& what)
{
  std::vector<Polyline> outlines;
  for (const BoundaryLoop& loop : boundaries)
    if (loop.type == LoopType::Outer || loop.type == LoopType::Inner)
      outlines.push_back(loop.curve);
  const std::vector<Eigen::Vector3f> made = pointsOn(rims, 0.5 * spacing), here = pointsOn(outlines, 0.5 * spacing);
  if (made.empty() || here.empty())
    return invalid(Diagnostic(what, " has no rim: make it again"));
  const auto farFrom = [spacing](const std::vector<Eigen::Vector3f>& points, const PointBlocks& line) {
    return std::find_if(points.begin(), points.end(), [&](const Eigen::Vector3f& f) {
      const Vector3d p = f.cast<double>();
      return (line.position(line.nearest(p)) - p).norm() > known_outline * spacing;
    });
  };
  const char* remedy = ": make it again on this surface, with the boundaries, rim and margin of this path";
  if (const auto off = farFrom(made, PointBlocks(here)); off != made.end())
    return invalid(Diagnostic(what, " was made on another surface or between other boundaries: it has a rim at ",
                              Place(off->cast<double>()), ", where there is none", remedy));
  if (const auto off = farFrom(here, PointBlocks(made)); off != here.end())
    return invalid(Diagnostic(what, " was made on another surface or between other boundaries: it has no rim at ",
                              Place(off->cast<double>()), ", where there is one", remedy));
  return Status::success();
}

/** The path of a field, of loops, or of both. */
Status
linkGiven(const GivenParts& given, const Surface& surface, const std::vector<BoundaryLoop>& boundaries, const SpiralSettings& settings,
          const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopReport& figures)
{
  if (given.field) {
    std::vector<Polyline> rims;
    for (const std::vector<std::uint32_t>& rim : given.field->mesh.rims) {
      rims.emplace_back();
      for (const std::uint32_t node : rim)
        rims.back().push_back(given.field->mesh.positions[node]);
    }
    if (const Status status = checkRims(rims, boundaries, surface.spacing(), "the field"); !status.ok())
      return status;
    if (const Status status = checkPathSize(scallopPathSize(*given.field, surface, settings), surface.area(), settings); !status.ok())
      return status;
  }
  if (given.loops) {
    std::vector<Polyline> rims;
    for (const ScallopLoop& loop : *given.loops)
      if (loop.level == 0)
        rims.push_back(loop.points);
    if (const Status status = checkRims(rims, boundaries, surface.spacing(), "the set of loops"); !status.ok())
      return status;
  }
  return linkOnField(given.field.get(), given.loops.value_or(std::vector<ScallopLoop>()), settings, progress, clock, path, figures);
}

/** What is wrong with point \p i of a path that was modified; empty if nothing is. */
Diagnostic
faultOf(const SpiralPath& path, std::size_t i, const Surface& surface)
{
  const auto unit = [](double squared) { return std::abs(squared - 1.0) < 1e-3; };
  if (!path.contacts[i].allFinite() || !unit(path.normals[i].squaredNorm()) || !unit(path.axes[i].squaredNorm()) ||
      !(std::abs(path.turns[i]) < most_turns))
    return "has a number that is not finite, or a normal or an axis that is not of length 1";
  if (!(surface.normal(surface.graph().blocks().nearest(path.contacts[i])).dot(path.normals[i]) > 0.0))
    return "has a normal into the material";
  if (!(path.axes[i].cast<double>().dot(path.normals[i]) > std::sin(1.0 * degree)))
    return "has a tool axis that leans 89 {degrees} or more from the normal";
  if (!path.feet.empty()) {
    const double lift = (path.contacts[i] - path.feet[i]).norm();
    if (!(path.lifts[i] >= 0.0f) || !(std::abs(lift - path.lifts[i]) < 1e-3))
      return Diagnostic("is ", lift, " {mm} from its foot, but its lift is ", path.lifts[i], " {mm}");
  }
  return "";
}

/** The figures of \p path that can be read from it. */
void
measureAxes(const SpiralPath& path, AxisReport& figures)
{
  figures.largest_change = figures.largest_rate = figures.largest_lean = 0.0;
  const auto angle = [](const Vector3d& a, const Vector3d& b) { return angleBetween(a, b) * in_degrees; };
  for (std::size_t i = 0; i < path.axes.size(); ++i) {
    const Vector3d axis = path.axes[i].cast<double>();
    figures.largest_lean = std::max(figures.largest_lean, angle(axis, path.normals[i]));
    if (i == 0 || beginsPass(path.passes, i))
      continue;
    const double change = angle(axis, path.axes[i - 1].cast<double>()), way = (path.contacts[i] - path.contacts[i - 1]).norm();
    figures.largest_change = std::max(figures.largest_change, change);
    if (way > 0.0)
      figures.largest_rate = std::max(figures.largest_rate, change / way);
  }
}

} // namespace

Status
checkGivenParts(const GivenParts& given, const SpiralSettings& settings, bool lines_given)
{
  std::vector<const char*> names;
  const auto add = [&names](bool is_given, const char* name) {
    if (is_given)
      names.emplace_back(name);
  };
  add(lines_given, "radial lines");
  add(given.field && !given.loops, "a step-over field");
  add(given.loops.has_value(), "loops");
  add(given.linked.has_value(), "a linked path");
  add(given.curve.has_value(), "a curve");
  add(given.planner != nullptr, "a planner");
  if (names.size() > 1)
    return invalid(Diagnostic(names[0], " and ", names[1], " are given, but only one of them can make the path: take one back"));
  if (given.empty())
    return Status::success();
  if (settings.method != SpiralMethod::Shortest && settings.method != SpiralMethod::ConstantScallop)
    return invalid(Diagnostic(names[0],
                              " must not be given to the radial or the published method, which makes the whole path: take it back, or "
                              "choose constant scallop height ({setMethod})"));
  SpiralSettings as_checked = settings; // centre, lines and pitch belong to another path
  as_checked.method = SpiralMethod::ConstantScallop;
  if (const Status status = checkSettings(as_checked); !status.ok())
    return status;
  const StepOverBasis used{settings.tool_radius, settings.scallop_height};
  if (given.field)
    for (const Status& status : {checkField(*given.field), checkBasis(given.field->basis, used, "the field")})
      if (!status.ok())
        return status;
  if (given.loops) {
    if (const Status status = checkScallopLoops(*given.loops); !status.ok())
      return status;
    for (const ScallopLoop& loop : *given.loops)
      if (const Status status = checkBasis(loop.basis, used, "the set of loops"); !status.ok())
        return status;
  }
  return given.linked ? checkBasis(given.linked->basis, used, "the linked path") : Status::success();
}

Status
planGiven(const GivenParts& given, const Surface& surface, const std::vector<BoundaryLoop>& boundaries, const SpiralSettings& settings,
          const ProgressCallback& progress, StageClock& clock, SpiralTurns& turns, ScallopReport& figures)
{
  turns = SpiralTurns();
  figures = ScallopReport();
  LinkedPath path;
  Status status = Status::success();
  if (given.planner) {
    status = given.planner->plan({surface, boundaries, settings, progress}, path);
    clock.end("planner");
    if (status.ok() && progress && !progress(1.0, "planner"))
      return {StatusCode::Cancelled, "cancelled"};
    path.basis = {settings.tool_radius, settings.scallop_height};
    if (status.ok())
      status = checkLinked(path, "the planner's path");
  }
  else if (given.curve) {
    path = linked(*given.curve);
    status = checkLinked(path, "the curve");
  }
  else if (given.linked) {
    path = *given.linked;
    status = checkLinked(path, "the linked path");
  }
  else
    status = linkGiven(given, surface, boundaries, settings, progress, clock, path, figures);
  if (status.ok() && given.ofUser())
    status = follow(surface, path);
  if (status.ok() && (given.ofUser() || given.linked)) {
    measureLinked(path, figures);
    status = checkHoles(path, boundaries, surface.spacing());
  }
  return status.ok() ? samplePath(path, surface, settings, turns) : status;
}

Status
modifyPath(const std::vector<std::shared_ptr<const PathModifier>>& modifiers, const Surface& surface, const SpiralSettings& settings,
           SpiralPath& path, AxisReport& axes, GapReport& gaps)
{
  for (std::size_t m = 0; m < modifiers.size(); ++m) {
    if (!modifiers[m])
      return invalid(Diagnostic("modifier ", m, " is a null pointer: give a modifier, or leave it out"));
    if (const Status status = modifiers[m]->modify(surface, settings, path); !status.ok())
      return status;
    const std::size_t n = path.contacts.size();
    const std::size_t sizes[] = {path.normals.size(), path.axes.size(), path.turns.size(), path.over_gap.size()};
    for (const std::size_t size : sizes)
      if (size != n)
        return invalid(Diagnostic("a modifier left a path with ", n, " contacts, ", sizes[0], " normals, ", sizes[1], " axes, ", sizes[2],
                                  " turns and ", sizes[3], " marks of gaps: keep one of each for every contact"));
    if (path.feet.size() != path.lifts.size() || (!path.feet.empty() && path.feet.size() != n))
      return invalid(Diagnostic("a modifier left a path with ", n, " contacts, ", path.feet.size(), " feet and ", path.lifts.size(),
                                " lifts: keep one of each for every contact, or none"));
    if (n == 0)
      return invalid("a modifier left a path without points: refuse such a path in the modifier");
    for (std::size_t i = 0; i < n; ++i)
      if (const Diagnostic fault = faultOf(path, i, surface); !fault.empty())
        return invalid(Diagnostic("a modifier left a path that is wrong: point ", i, ", ", Place(path.contacts[i]), ", ", fault));
    if (const Status status = checkPasses(path.passes, n, "the modified path"); !status.ok())
      return status;
  }
  path.arc_lengths = cutLengths(path);
  measureAxes(path, axes);
  return measureGaps(path, settings, gaps);
}

} // namespace pcl_spiral
