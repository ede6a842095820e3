// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/verify/impl/cutter_path.h>

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral {
namespace {

double
degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return angleBetween(a, b) * 180.0 / pi;
}

/** Refuse the arc lengths of a path with lifts if their total growth \p grow does not fit the cuts: then they show no lifts. */
Status
checkLifts(const CutterPath& path, double grow)
{
  constexpr double rounding = 0.02; // of the length
  const double cut = cutLength(path);
  if (path.passes.empty() || std::abs(grow - cut) <= rounding * grow)
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic("the arc lengths of the toolpath stay the same over ", path.passes.size(),
                                               " moves, as they do at lifts, first at path point ", path.passes.front(),
                                               ", but the other moves are ", cut, " {mm} long and the arc lengths grow by ", grow,
                                               " {mm}: write arc lengths to a hundredth of a millimetre, or write none")};
}

/** Refuse given passes that do not begin one after the other within a path of \p size points. */
Status
checkPasses(const std::vector<std::size_t>& passes, std::size_t size)
{
  std::size_t before = 0;
  for (const std::size_t begin : passes) {
    if (begin <= before || begin >= size)
      return {StatusCode::InvalidInput,
              Diagnostic("a pass begins at path point ", begin, ", after ", before, " of ", size,
                         ": give the first point of the second pass and of each later one, ascending ({setInputToolpath})")};
    before = begin;
  }
  return Status::success();
}

} // namespace

Status
readCutterPath(const pcl::PointCloud<ToolpathPoint>::ConstPtr& toolpath, CutterPath& path, const std::vector<std::size_t>& passes)
{
  path = CutterPath();
  if (!toolpath)
    return {StatusCode::InvalidInput, "no toolpath: call {setInputToolpath}"};
  if (toolpath->size() < 2)
    return {StatusCode::InvalidInput, Diagnostic("the toolpath has ", toolpath->size(), " points; a move needs two: check the file")};
  bool with_axes = true;
  for (std::size_t i = 0; i < toolpath->size(); ++i) {
    const ToolpathPoint& p = (*toolpath)[i];
    const Eigen::Vector3d contact = p.getVector3fMap().cast<double>();
    const Eigen::Vector3d normal = p.getNormalVector3fMap().cast<double>();
    const Eigen::Vector3d axis = p.getAxisVector3fMap().cast<double>();
    if (!contact.allFinite())
      return {StatusCode::InvalidInput, Diagnostic("toolpath point ", i, " is not finite: check the file")};
    if (!(normal.norm() > 1e-6) || !normal.allFinite())
      return {StatusCode::InvalidInput,
              Diagnostic("toolpath point ", i, " has no normal: without it the place of the cutter is not known")};
    path.contacts.push_back(contact);
    path.normals.push_back(normal.normalized());
    path.turns.push_back(p.turn);
    path.lifts.push_back(p.lift);
    with_axes = with_axes && axis.allFinite() && axis.norm() > 1e-6;
    if (with_axes)
      path.axes.push_back(axis.normalized());
  }
  if (!with_axes)
    path.axes.clear();
  if (!passes.empty()) {
    path.passes = passes;
    return checkPasses(passes, path.size());
  }
  path.passes = passBegins(*toolpath);
  return checkLifts(path, toolpath->back().arc_length - toolpath->front().arc_length);
}

double
cutLength(const CutterPath& path)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!beginsPass(path.passes, i))
      sum += (path.contacts[i] - path.contacts[i - 1]).norm();
  return sum;
}

PathMotion
pathMotion(const CutterPath& path)
{
  PathMotion motion;
  Eigen::Vector3d before = Eigen::Vector3d::Zero(); // the last move longer than zero
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (beginsPass(path.passes, i + 1)) {
      before.setZero();
      ++motion.lifts;
      motion.lift_length += (path.contacts[i + 1] - path.contacts[i]).norm();
      continue;
    }
    const Eigen::Vector3d move = path.contacts[i + 1] - path.contacts[i];
    motion.length += move.norm();
    raise(motion.gap, move.norm(), path.contacts[i], i);
    if (!move.isZero(0.0)) {
      if (!before.isZero(0.0))
        raise(motion.turn, degreesBetween(before, move), path.contacts[i], i);
      before = move;
    }
    raise(motion.normal_change, degreesBetween(path.normals[i], path.normals[i + 1]), path.contacts[i], i);
    if (!path.axes.empty())
      raise(motion.axis_change, degreesBetween(path.axes[i], path.axes[i + 1]), path.contacts[i], i);
  }
  return motion;
}

} // namespace pcl_spiral
