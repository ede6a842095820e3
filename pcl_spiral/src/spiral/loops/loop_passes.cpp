// SPDX-License-Identifier: BSD-3-Clause
// Checks closed loops and makes a toolpath of them as they are.
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/scallop_loops.h>

#include "core/tilted_axes.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** The loop as a path that ends where it begins, in turn \p number. */
LinkedPath
pathOf(const ScallopLoop& loop, std::size_t number, bool clockwise)
{
  LinkedPath path;
  path.points = loop.points;
  path.metric = loop.metric;
  if (clockwise) {
    std::reverse(path.points.begin(), path.points.end());
    std::reverse(path.metric.begin(), path.metric.end());
  }
  path.points.push_back(path.points.front());
  path.metric.push_back(path.metric.front());
  const std::size_t n = path.points.size();
  for (std::size_t i = 0; i < n; ++i)
    path.turns.push_back(static_cast<float>(number) + static_cast<float>(i) / static_cast<float>(n - 1));
  path.reversed.assign(n, 0);
  path.basis = loop.basis;
  return path;
}

/** The pass of a path whose last contact is its first; feed directions at the joint use points on both sides of it. */
DrivePass
passOf(SpiralPath path, const SpiralSettings& settings)
{
  DrivePass pass;
  pass.closed = true;
  path.contacts.pop_back();
  path.normals.pop_back();
  const std::size_t n = path.contacts.size();
  Polyline round{path.contacts.back()};
  std::vector<Eigen::Vector3d> normals{path.normals.back()};
  round.insert(round.end(), path.contacts.begin(), path.contacts.end());
  normals.insert(normals.end(), path.normals.begin(), path.normals.end());
  round.push_back(path.contacts.front());
  normals.push_back(path.normals.front());
  const std::vector<Eigen::Vector3d> axes = tiltedAxes(round, normals, settings.tilt_angle * pi / 180.0, settings.lead_angle * pi / 180.0);
  for (std::size_t i = 0; i < n; ++i)
    pass.points.push_back({path.contacts[i], axes[i + 1], path.normals[i]});
  return pass;
}

} // namespace

Status
checkScallopLoops(const std::vector<ScallopLoop>& loops)
{
  const auto wrong = [](std::size_t i, const Diagnostic& what) -> Status {
    return {StatusCode::InvalidInput, Diagnostic("loop ", i, " ", what)};
  };
  if (loops.empty())
    return {StatusCode::InvalidInput, "there are no loops: give loops made by {ScallopLoops}"};
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const ScallopLoop& loop = loops[i];
    if (loop.points.size() < 3)
      return wrong(i, Diagnostic("has ", loop.points.size(), " points: give at least three"));
    if (loop.metric.size() != loop.points.size() || loop.arcs.size() != loop.points.size() + 1)
      return wrong(i, Diagnostic("has ", loop.points.size(), " points, ", loop.metric.size(), " metrics and ", loop.arcs.size(),
                                 " arc lengths: give one metric per point, and call measure"));
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      if (!loop.points[k].allFinite() || !loop.metric[k].matrix().allFinite() || !(loop.metric[k].matrix().trace() > 0.0))
        return wrong(i, Diagnostic("has an impossible position or metric at point ", k, ", ", Place(loop.points[k]), ": remove the point"));
    if (!(loop.length() > 0.0) || !std::isfinite(loop.length()))
      return wrong(i, Diagnostic("at ", Place(loop.points.front()), " has the length ", loop.length(),
                                 " step-overs: remove the loop, or call measure"));
  }
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (const Status status = checkBasis(loops[i].basis, loops.front().basis, Diagnostic("loop ", i)); !status.ok())
      return status;
  if (loops.front().level != 0)
    return wrong(0, Diagnostic("at ", Place(loops.front().points.front()), " has the level ", loops.front().level,
                               ", but the first loop must be the outer rim, of level 0: put the rim first"));
  return Status::success();
}

Status
putLoopsOnSurface(const std::vector<ScallopLoop>& loops, const Surface& surface, const SpiralSettings& settings,
                  const ProgressCallback& progress, DrivePasses& passes)
{
  passes.clear();
  if (const Status status = checkScallopLoops(loops); !status.ok())
    return status;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (progress && !progress(static_cast<double>(i) / static_cast<double>(loops.size()), "projection"))
      return {StatusCode::Cancelled, "cancelled"};
    const LinkedPath path = pathOf(loops[i], i, settings.sense == SpiralSense::Clockwise);
    std::vector<SpiralPoint> points;
    double longest_step = 0.0;
    if (const Status status = samplePath(path, surface, settings, points, longest_step); !status.ok())
      return status;
    SpiralPath on_surface;
    GapReport gaps;
    if (const Status status = putOnSurface(points, surface, settings, longest_step, {}, on_surface, gaps); !status.ok())
      return status;
    passes.push_back(passOf(std::move(on_surface), settings));
  }
  return Status::success();
}

} // namespace pcl_spiral
