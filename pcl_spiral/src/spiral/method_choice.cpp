// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/method_choice.h>

#include "core/turn_time.h"
#include "geodesic/distance_field.h"
#include "spiral/lines/surface_centre.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/search/impl/point_selection.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_points = 20000; // used for the prediction
constexpr std::size_t curvature_samples = 1000;
constexpr std::size_t rim_samples = 256;
constexpr double scallop_rims = 0.6;   // of the rims' length, added to the turns: at least half, and a little to begin and end the path
constexpr double radial_rims = 1.1;    // the same: the last turn runs on the rim, where half is the least, and the first about the centre
constexpr double beside_points = 0.33; // spacings from the outermost points to the outline
constexpr double turn_radius = 0.25;   // step-overs: of the sharp bends of ConstantScallop
constexpr double tie = 1.02;           // ratio of predicted times up to which Radial is chosen: it has no sharp bends
constexpr double fine_turns = 0.25;    // spacings: if turns lie closer, loops follow the triangles of the mesh, and Radial is chosen
constexpr double fine_tie = 1.1;       // up to this ratio

/** The whole of \p surface with fewer points. */
SurfaceGraph
coarseGraph(const Surface& surface, double area)
{
  const SurfaceGraph& graph = surface.graph();
  const std::vector<Eigen::Vector3f>& points = graph.blocks().points();
  SurfaceGraphOptions options;
  std::vector<Eigen::Vector3f> kept;
  for (const std::uint32_t i : voxelRepresentatives(points, std::sqrt(area / static_cast<double>(most_points)))) {
    kept.push_back(points[i]);
    options.given_normals.push_back(graph.normals()[i]);
  }
  SurfaceGraph coarse;
  if (!coarse.build(std::move(kept), options).ok())
    return SurfaceGraph();
  return coarse;
}

/** Area of the triangles, mm2. */
double
areaOf(const SurfaceGraph& graph)
{
  double area = 0.0;
  for (std::size_t t = 0; t < graph.triangulation().triangleCount(); ++t) {
    const auto& c = graph.triangulation().triangle(t);
    area += 0.5 * (graph.position(c[1]) - graph.position(c[0])).cross(graph.position(c[2]) - graph.position(c[0])).norm();
  }
  return area;
}

/** Mean of the largest step-overs that the height allows. */
double
meanStepOver(const MlsSurface& surface, const SpiralSettings& settings)
{
  std::vector<Eigen::Vector3d> queries;
  const std::size_t stride = std::max<std::size_t>(1, surface.graph().size() / curvature_samples);
  for (std::size_t i = 0; i < surface.graph().size(); i += stride)
    queries.push_back(surface.graph().position(i));
  std::vector<SurfaceFoot> feet;
  surface.project(queries, feet);
  const double flat = stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(0.0);
  double inverse = 0.0; // a mean of 1 / step-over, because the number of turns follows from it
  for (const SurfaceFoot& foot : feet) {
    const double least = foot.valid ? spacingCurvature(settings.tool_radius, std::min(foot.curvature1, foot.curvature2)) : 0.0;
    inverse += 1.0 / std::min(4.0 * flat, stepOver(settings.tool_radius, least, settings.scallop_height).value_or(4.0 * flat));
  }
  return static_cast<double>(feet.size()) / inverse;
}

/** Distances that turns must cover from the source to points at even steps along \p rim: d cos(psi). */
std::vector<double>
heightsAlong(const Polyline& rim, const DistanceField& field)
{
  const Polyline points = resampled(rim, rim_samples, true);
  std::vector<double> d(points.size()), heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    d[i] = field.distanceAt(points[i]);
  constexpr std::size_t reach = 2; // samples on either side, for the slope along the rim
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + reach) % points.size(), before = (i + points.size() - reach) % points.size();
    double way = 0.0;
    for (std::size_t k = before; k != next; k = (k + 1) % points.size())
      way += (points[(k + 1) % points.size()] - points[k]).norm();
    const double sine = std::clamp((d[next] - d[before]) / way, -1.0, 1.0);
    heights[i] = d[i] * std::sqrt(1.0 - sine * sine);
  }
  return heights;
}

/** The largest number of turns that a line needs, over the mean along the rim; nothing if distances are not known. */
std::optional<double>
unevenness(const SurfaceGraph& graph, const MlsSurface& surface, const BoundaryLoop& rim, const BoundaryLoop* hole)
{
  DistanceField field;
  if (hole) {
    if (!field.compute(graph, hole->curve))
      return std::nullopt;
  }
  else {
    const auto centre = deepestPoint(surface, rim.curve); // close to the balanced one where Radial is suitable
    if (!centre || !field.compute(graph, *centre))
      return std::nullopt;
  }
  const std::vector<double> heights = heightsAlong(rim.curve, field);
  double largest = 0.0, sum = 0.0;
  for (const double height : heights) {
    if (!std::isfinite(height))
      return std::nullopt;
    largest = std::max(largest, height);
    sum += height;
  }
  return sum > 0.0 ? std::optional<double>(largest * static_cast<double>(heights.size()) / sum) : std::nullopt;
}

/** Why turns at equal shares of radial lines are impossible; empty if nothing is known against them. */
Diagnostic
whyNoRadial(const std::vector<const BoundaryLoop*>& holes, const SpiralSettings& settings)
{
  if (!holes.empty() && settings.hole_margin > 0.0)
    return "a radial path about a hole begins at the hole, but a hole margin is set";
  if (holes.size() > 1)
    return Diagnostic("the surface has ", holes.size(), " holes");
  return {};
}

/** Why such turns lie unevenly; empty if they do not. */
Diagnostic
cornerText(const BoundaryLoop& rim, const std::vector<const BoundaryLoop*>& holes)
{
  if (!rim.corners.empty())
    return Diagnostic("the rim has a corner at ", Place(rim.curve[rim.corners.front()]));
  if (!holes.empty() && !holes.front()->corners.empty())
    return Diagnostic("the hole has a corner at ", Place(holes.front()->curve[holes.front()->corners.front()]));
  return {};
}

} // namespace

SpiralMethod
methodAsked(const SpiralSettings& settings)
{
  const bool radial = settings.centre || settings.lines != LineMethod::Automatic || settings.pitch == Pitch::AlongLine;
  return settings.method == SpiralMethod::Shortest && radial ? SpiralMethod::Radial : settings.method;
}

MethodForesight
foreseeMethods(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings)
{
  MethodForesight foresight;
  const BoundaryLoop* rim = nullptr;
  std::vector<const BoundaryLoop*> holes;
  double rims = 0.0;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::Outer)
      rim = &loop;
    else if (loop.type == LoopType::Inner)
      holes.push_back(&loop);
    rims += loop.type == LoopType::ScanGap ? 0.0 : loop.length;
  }
  const bool small = surface.size() <= most_points;
  SurfaceGraph coarse;
  if (!small)
    coarse = coarseGraph(surface, surface.area());
  const SurfaceGraph& graph = small || coarse.size() == 0 ? surface.graph() : coarse;
  const MlsSurface fit(graph);
  const double step_over = meanStepOver(fit, settings);
  const double across = (areaOf(graph) + beside_points * graph.spacing() * rims) / step_over;
  const double turns = 2.0 * across / rims;
  const TurnPace pace{settings.feed / 60.0, settings.acceleration, settings.chord_error,
                      settings.max_step > 0.0 ? settings.max_step : settings.tool_radius};
  const double middle = rims / (4.0 * pi), per_length = roundTime(pace, middle); // half as far round as the rims
  foresight.scallop_length = across + scallop_rims * rims;
  foresight.why_not_radial = whyNoRadial(holes, settings);
  foresight.radial_fails = !foresight.why_not_radial.empty();
  if (!foresight.radial_fails)
    foresight.why_not_radial = cornerText(*rim, holes);
  std::optional<double> uneven;
  if (foresight.why_not_radial.empty())
    uneven = unevenness(graph, fit, *rim, holes.empty() ? nullptr : holes.front());
  if (!uneven && foresight.why_not_radial.empty()) {
    foresight.why_not_radial = "no radial lines lead from a centre to the rim";
    foresight.radial_fails = true;
  }
  const double ridge_turns = uneven.value_or(2.0) > 1.02 ? 2.0 * turns : 0.0;
  foresight.scallop_time =
      per_length * foresight.scallop_length + ridge_turns * std::max(0.0, bendTime(pace, turn_radius * step_over, middle));
  if (uneven)
    foresight.radial_length = across * *uneven + radial_rims * rims;
  foresight.radial_time = per_length * foresight.radial_length;
  const double worth = step_over < fine_turns * surface.spacing() ? fine_tie : tie;
  if (foresight.why_not_radial.empty() && foresight.radial_time <= worth * foresight.scallop_time)
    foresight.method = SpiralMethod::Radial;
  return foresight;
}

} // namespace pcl_spiral
