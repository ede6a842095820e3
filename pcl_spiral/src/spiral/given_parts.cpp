// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/given_parts.h>

#include "spiral/field/scallop_size.h"
#include "spiral/path/given_path.h"

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace pcl_spiral {
namespace {

Status
invalid(std::string message)
{
  return {StatusCode::InvalidArgument, std::move(message)};
}

/** Ok, or an error if passes do not begin at points between the first and the last of \p size, in order. */
Status
checkPasses(const std::vector<std::size_t>& passes, std::size_t size, const std::string& what)
{
  std::size_t before = 0;
  for (const std::size_t begin : passes) {
    if (begin <= before || begin >= size)
      return invalid(textOf(what, " has a pass that begins at point ", begin, ", after point ", before, " of ", size,
                            ": give the first points of the second and each later pass, in their order"));
    before = begin;
  }
  return Status::success();
}

/** Ok, or an error if \p path cannot be sampled. Turns that are not given are 0. */
Status
checkLinked(LinkedPath& path, const std::string& what)
{
  if (const Status status = checkGiven(path.points.size(), what); !status.ok())
    return status;
  const std::size_t n = path.points.size();
  if (n < 2)
    return invalid(what + " has one point: give two or more");
  if (path.turns.empty())
    path.turns.assign(n, 0.0f);
  if (path.turns.size() != n)
    return invalid(textOf(what, " has ", n, " points and ", path.turns.size(), " turns: give one for each point, or none"));
  for (std::size_t i = 0; i < n; ++i)
    if (!path.points[i].allFinite() || !std::isfinite(path.turns[i]))
      return invalid(textOf("point ", i, " of ", what, " is not finite: remove it"));
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

} // namespace

Status
checkGivenParts(const GivenParts& given, const SpiralSettings& settings, bool lines_given)
{
  std::vector<std::string> names;
  const auto add = [&names](bool is_given, const char* name) {
    if (is_given)
      names.emplace_back(name);
  };
  add(lines_given, "radial lines");
  add(given.field && given.loops.empty(), "a step-over field");
  add(!given.loops.empty(), "loops");
  add(!given.linked.points.empty(), "a linked path");
  add(!given.curve.empty(), "a curve");
  add(given.planner != nullptr, "a planner");
  if (names.size() > 1)
    return invalid(names[0] + " and " + names[1] + " are given, but only one of them can make the path: take one back");
  if (given.empty())
    return Status::success();
  if (settings.method != SpiralMethod::Shortest && settings.method != SpiralMethod::ConstantScallop)
    return invalid(names[0] + " must not be given to the radial or the published method, which makes the whole path: take it back, or "
                              "choose constant scallop height (setMethod)");
  const StepOverBasis used{settings.tool_radius, settings.scallop_height};
  if (given.field)
    for (const Status& status : {checkField(*given.field), checkBasis(given.field->basis, used, "the field")})
      if (!status.ok())
        return status;
  if (!given.loops.empty()) {
    if (const Status status = checkScallopLoops(given.loops); !status.ok())
      return status;
    for (const ScallopLoop& loop : given.loops)
      if (const Status status = checkBasis(loop.basis, used, "the set of loops"); !status.ok())
        return status;
  }
  return checkBasis(given.linked.basis, used, "the linked path");
}

Status
planGiven(const GivenParts& given, const Surface& surface, const std::vector<BoundaryLoop>& boundaries, const SpiralSettings& settings,
          const ProgressCallback& progress, StageClock& clock, SpiralTurns& turns, ScallopFigures& figures)
{
  turns = SpiralTurns();
  figures = ScallopFigures();
  LinkedPath path;
  Status status = Status::success();
  if (given.planner) {
    status = given.planner->plan({surface, boundaries, settings, progress}, path);
    path.basis = {settings.tool_radius, settings.scallop_height};
    clock.end("planner");
    if (status.ok())
      status = checkLinked(path, "the planner's path");
  }
  else if (!given.curve.empty()) {
    path = linked(given.curve);
    status = checkLinked(path, "the curve");
  }
  else if (!given.linked.points.empty()) {
    path = given.linked;
    status = checkLinked(path, "the linked path");
  }
  else if (given.field)
    status = checkPathSize(scallopPathSize(*given.field, surface, settings), surface.area(), settings);
  if (status.ok() && !given.ofUser())
    status = linkOnField(given.field.get(), given.loops, settings, progress, clock, path, figures);
  return status.ok() ? samplePath(path, surface, settings, turns.curve, turns.largest_allowed_step) : status;
}

Status
modifyPath(const std::vector<std::shared_ptr<const PathModifier>>& modifiers, const Surface& surface, const SpiralSettings& settings,
           SpiralPath& path)
{
  for (const std::shared_ptr<const PathModifier>& modifier : modifiers) {
    if (const Status status = modifier->modify(surface, settings, path); !status.ok())
      return status;
    const std::size_t n = path.contacts.size();
    if (const Status status = checkGiven(n, "the modified path"); !status.ok())
      return status;
    const std::size_t sizes[] = {path.normals.size(), path.axes.size(), path.turns.size(), path.over_gap.size()};
    for (const std::size_t size : sizes)
      if (size != n)
        return invalid(textOf("a modifier left a path with ", n, " contacts, ", sizes[0], " normals, ", sizes[1], " axes, ", sizes[2],
                              " turns and ", sizes[3], " marks of gaps: keep one of each for every contact"));
    if (path.feet.size() != path.lifts.size() || (!path.feet.empty() && path.feet.size() != n))
      return invalid(textOf("a modifier left a path with ", n, " contacts, ", path.feet.size(), " feet and ", path.lifts.size(),
                            " lifts: keep one of each for every contact, or none"));
    const auto unit = [](double squared) { return std::abs(squared - 1.0) < 1e-3; };
    for (std::size_t i = 0; i < n; ++i)
      if (!path.contacts[i].allFinite() || !unit(path.normals[i].squaredNorm()) || !unit(path.axes[i].squaredNorm()) ||
          !std::isfinite(path.turns[i]))
        return invalid(textOf("a modifier left point ", i, " of the path, ", placeText(path.contacts[i]),
                              ", with a number that is not finite, or a normal or an axis that is not of length 1"));
    if (const Status status = checkPasses(path.passes, n, "the modified path"); !status.ok())
      return status;
    path.arc_lengths = cutLengths(path);
  }
  return Status::success();
}

} // namespace pcl_spiral
