// SPDX-License-Identifier: BSD-3-Clause
#include "published_path.h"
#include "common/stoppable_loop.h"
#include "core/angle_between.h"

#include "published_step.h"

#include "core/tilted_axes.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {} // namespace

Status
publishedCurve(const SurfaceGraph& graph, const SpiralSettings& settings, PublishedResult& result, std::vector<SpiralPoint>& curve)
{
  const RadialLineSet& set = result.lines;
  PublishedReport& figures = result.figures;
  const auto step_over = stepOverPublished(settings.tool_radius, settings.scallop_height); // (16)
  if (!step_over)
    return {StatusCode::InvalidArgument,
            Diagnostic("there is no step-over for a tool radius of ", settings.tool_radius, " {mm} and a scallop height of ",
                       settings.scallop_height, " {mm}: both must be above 0, the height below the radius")};
  figures.step_over = *step_over;
  SpiralSettings published = settings;
  published.pitch = Pitch::AlongLine; // (17)-(19)
  figures.step = publishedStep(set.lines, settings.chord_error,
                               settings.max_step > 0.0 ? settings.max_step : settings.tool_radius); // (13)-(15)
  published.max_step = figures.step;
  if (!(figures.step > 0.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("there is no step for a chord error of ", settings.chord_error, " {mm}: set it above 0")};
  TurnFunction turns(set.lines, published, graph.spacing());
  turns.setEvenSteps(figures.step_over, figures.step);
  if (const Status status = turns.compute(); !status.ok())
    return status;
  figures.turns = turns.turns();
  if (const Status status = checkPathSize(turns.pathSize(), surfaceArea(graph), published); !status.ok())
    return status;
  SpiralCurve spiral(set.lines, turns, published, graph.spacing());
  spiral.setRim(set.rim, set.rim_corners);
  if (!set.inner.empty())
    spiral.setInner(set.inner, set.inner_corners);
  curve = spiral.sample();
  return Status::success();
}

Status
publishedContacts(const MlsSurface& surface, const SpiralSettings& settings, const std::vector<SpiralPoint>& curve,
                  const std::function<bool(double)>& progress, PublishedResult& result)
{
  const SurfaceGraph& graph = surface.graph();
  result.contacts.resize(curve.size());
  result.normals.resize(curve.size());
  result.turns.resize(curve.size());
  std::size_t too_hollow = 0, first_hollow = 0;
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < curve.size(); begin += report_chunk) {
    const std::size_t end = std::min(curve.size(), begin + report_chunk);
    queries.clear();
    for (std::size_t i = begin; i < end; ++i)
      queries.push_back(curve[i].position);
    surface.project(queries, feet); // (8)-(11)
    for (std::size_t i = begin; i < end; ++i) {
      const SurfaceFoot& foot = feet[i - begin];
      if (!foot.valid)
        return {StatusCode::Failed,
                Diagnostic("the path leaves the {scanned surface} at ", Place(curve[i].position), " in turn ", curve[i].turn,
                           ": there is a gap, or the rim is too ragged for the projection ", "to the directional centroid")};
      result.contacts[i] = foot.position;
      result.normals[i] = graph.normal(foot.nearest);
      result.turns[i] = static_cast<float>(curve[i].turn);
      if (settings.tool_radius * foot.curvature2 <= -1.0 && too_hollow++ == 0)
        first_hollow = i;
    }
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(curve.size())))
      return {StatusCode::Cancelled, "cancelled"};
  }
  if (too_hollow > 0)
    result.warnings.push_back(Diagnostic("at ", too_hollow, " path points, first at ", Place(result.contacts[first_hollow]),
                                         ", the surface is hollow with a radius below the tool radius of ", settings.tool_radius,
                                         " {mm}: the cutter gouges there; the published step-over does not use the curvature"));
  result.arc_lengths = arcLengths(result.contacts);
  return Status::success();
}

void
publishedAxes(const SpiralSettings& settings, PublishedResult& result)
{
  const auto axes = settings.fixed_axis
                        ? std::vector<Eigen::Vector3d>(result.contacts.size(), settings.fixed_axis->normalized())
                        : tiltedAxes(result.contacts, result.normals, settings.tilt_angle * degree, settings.lead_angle * degree);
  PublishedReport& figures = result.figures;
  result.axes.resize(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    result.axes[i] = axes[i].cast<float>();
    if (i == 0)
      continue;
    const double change = angleBetween(axes[i], axes[i - 1]) / degree;
    figures.largest_axis_change = std::max(figures.largest_axis_change, change);
    figures.longest_move = std::max(figures.longest_move, (result.contacts[i] - result.contacts[i - 1]).norm());
  }
}

} // namespace pcl_spiral
