// SPDX-License-Identifier: BSD-3-Clause
#include "line_source.h"

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

namespace pcl_spiral {
namespace {

constexpr std::size_t stations = 129; // on a line

Status
failedAt(const Eigen::Vector3d& place, const Diagnostic& what)
{
  return {StatusCode::Failed, Diagnostic(what, " at ", Place(place))};
}

/** Points of the graph nearest to a loop's own points, in the graph's order. */
std::vector<std::uint32_t>
graphPoints(const SurfaceGraph& graph, const BoundaryLoop& loop)
{
  std::vector<std::uint32_t> indices;
  for (const Eigen::Vector3d& p : loop.points)
    indices.push_back(graph.blocks().nearest(p));
  return indices;
}

} // namespace

LineSource::LineSource(const RadialLineRequest& request, const SurfaceCentre& centre, bool harmonic)
: request_(request), centre_(centre), harmonic_(harmonic)
{}

Status
LineSource::prepare()
{
  const SurfaceGraph& graph = request_.surface.graph();
  if (request_.inner)
    return potential_.compute(graph, graphPoints(graph, *request_.inner), request_.inner->curve, graphPoints(graph, request_.rim));
  if (harmonic_)
    return potential_.compute(graph, centre_.position, graphPoints(graph, request_.rim));
  return Status::success();
}

Polyline
LineSource::traced(const Eigen::Vector3d& place) const
{
  if (takesGuesses())
    return centre_.lines->between(centre_.position, place);
  Polyline line = potential_.trace(place);
  if (line.size() > 1) {
    line.back() = place;
    if (!request_.inner)
      line.front() = centre_.position;
  }
  return line;
}

Status
LineSource::make(const Polyline& rim_places, std::vector<Polyline> guesses, std::vector<RadialLine>& lines) const
{
  guesses.resize(rim_places.size());
  std::vector<std::uint8_t> guessed(rim_places.size(), 0);
  const auto count = static_cast<std::int64_t>(rim_places.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i)
    if (guesses[i].size() > 1)
      guessed[i] = 1;
    else
      guesses[i] = traced(rim_places[i]);
  for (std::size_t i = 0; i < guesses.size(); ++i)
    if (guesses[i].size() < 2)
      return failedAt(rim_places[i], "no line leads from the centre to the rim");
  lines.assign(rim_places.size(), RadialLine());
  const Status status = harmonic_ ? putOnSurface(guesses, lines) : refine(rim_places, guesses, guessed, lines);
  return status.ok() ? fit(lines) : status;
}

Status
LineSource::refine(const Polyline& rim_places, std::vector<Polyline>& starts, const std::vector<std::uint8_t>& guessed,
                   std::vector<RadialLine>& lines) const
{
  RefinementOptions options;
  options.max_iterations = 8;
  options.probe_normals = false; // a hundredth of a millimetre sideways does not matter to a radial line
  options.tolerance = 0.02 * request_.tolerance;
  // The predicted line is close, so only the finest level is used. A guess that leads off the surface is replaced by a traced line.
  for (const bool from_guess : {true, false}) {
    std::vector<GeodesicLine> geodesics;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].feet.empty() && (guessed[i] != 0 || !from_guess)) {
        which.push_back(i);
        geodesics.emplace_back();
        geodesics.back().points = from_guess || !guessed[i] ? std::move(starts[i]) : traced(rim_places[i]);
        if (geodesics.back().points.size() < 2)
          return failedAt(rim_places[i], "no line leads from the centre to the rim");
      }
    options.levels = {static_cast<int>(stations) - 1};
    if (!from_guess)
      options.levels.insert(options.levels.begin(), 32);
    refineGeodesics(request_.surface, options, geodesics);
    for (std::size_t j = 0; j < which.size(); ++j) {
      if (!geodesics[j].left_surface) {
        lines[which[j]].feet = std::move(geodesics[j].feet);
        lines[which[j]].unsettled = geodesics[j].converged ? 0.0 : geodesics[j].largest_move;
      }
      else if (!from_guess)
        return failedAt(geodesics[j].left_at, "the shortest line leaves the surface");
    }
  }
  return Status::success();
}

Status
LineSource::putOnSurface(std::vector<Polyline>& traces, std::vector<RadialLine>& lines) const
{
  std::vector<Eigen::Vector3d> queries;
  queries.reserve(traces.size() * stations);
  for (const Polyline& trace : traces) {
    const Polyline even = resampled(trace, stations);
    queries.insert(queries.end(), even.begin(), even.end());
  }
  std::vector<SurfaceFoot> feet;
  request_.surface.project(queries, feet);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].feet.assign(feet.begin() + i * stations, feet.begin() + (i + 1) * stations);
    for (std::size_t k = 0; k < stations; ++k)
      if (!lines[i].feet[k].valid)
        return failedAt(queries[i * stations + k], "a line leaves the surface");
    lines[i].feet.front().position = traces[i].front();
    lines[i].feet.back().position = traces[i].back();
  }
  return Status::success();
}

Status
LineSource::fit(std::vector<RadialLine>& lines) const
{
  BSplineFitOptions options;
  options.tolerance = request_.fit_tolerance;
  options.min_spans = 16;
  std::vector<std::uint8_t> failed(lines.size(), 0);
  const auto count = static_cast<std::int64_t>(lines.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t i = 0; i < count; ++i) {
    Polyline points;
    for (const SurfaceFoot& foot : lines[i].feet)
      points.push_back(foot.position);
    const auto result = fitBSpline(points, options);
    failed[i] = !result;
    if (!result)
      continue;
    lines[i].curve = result->curve;
    lines[i].deviation = result->max_deviation;
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (failed[i])
      return failedAt(lines[i].feet.back().position, "no curve fits the radial line that ends on the rim");
  return Status::success();
}

} // namespace pcl_spiral
