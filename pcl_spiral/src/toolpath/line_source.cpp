#include "line_source.h"

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/geodesic/geodesic_refinement.h>

#include <sstream>

namespace pcl_spiral {
namespace {

constexpr std::size_t stations = 129; // on a line

Status
failedAt(const Eigen::Vector3d& place, const std::string& what)
{
  std::ostringstream message;
  message << what << " at (" << place.transpose() << ")";
  return {StatusCode::Failed, message.str()};
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
{
}

Status
LineSource::prepare()
{
  const SurfaceGraph& graph = request_.surface.graph();
  if (request_.inner)
    return potential_.compute(graph, graphPoints(graph, *request_.inner), request_.inner->curve,
                              graphPoints(graph, request_.rim));
  if (harmonic_)
    return potential_.compute(graph, centre_.position, graphPoints(graph, request_.rim));
  distance_ = &centre_.field;
  if (distance_->size() == 0) { // of a given centre
    if (!own_distance_.compute(graph, centre_.position))
      return failedAt(centre_.position, "the centre does not lie on the surface");
    distance_ = &own_distance_;
  }
  return Status::success();
}

Status
LineSource::make(const Polyline& rim_places, std::vector<RadialLine>& lines) const
{
  const bool by_distance = !harmonic_ && !request_.inner;
  std::vector<Polyline> traces(rim_places.size());
  const auto count = static_cast<std::int64_t>(rim_places.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i)
    traces[i] = by_distance ? distance_->trace(rim_places[i]) : potential_.trace(rim_places[i]);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (traces[i].size() < 2)
      return failedAt(rim_places[i], "no line leads from the centre to the rim");
    traces[i].back() = rim_places[i];
    if (!request_.inner)
      traces[i].front() = centre_.position;
  }
  lines.assign(rim_places.size(), RadialLine());
  const Status status = harmonic_ ? putOnSurface(traces, lines) : refine(traces, lines);
  return status.ok() ? fit(lines) : status;
}

Status
LineSource::refine(std::vector<Polyline>& traces, std::vector<RadialLine>& lines) const
{
  std::vector<GeodesicLine> geodesics(traces.size());
  for (std::size_t i = 0; i < traces.size(); ++i)
    geodesics[i].points = std::move(traces[i]);
  RefinementOptions options;
  options.levels = {32, static_cast<int>(stations) - 1};
  options.max_iterations = 8;
  options.probe_normals = false; // a hundredth of a millimetre sideways is nothing to a radial line
  options.tolerance = 0.005 * request_.tolerance;
  refineGeodesics(request_.surface, options, geodesics);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (geodesics[i].left_surface)
      return failedAt(geodesics[i].left_at, "the shortest line leaves the surface");
    lines[i].feet = std::move(geodesics[i].feet);
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
