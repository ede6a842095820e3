// SPDX-License-Identifier: BSD-3-Clause
#include "published_lines.h"

#include "spiral/loops/loop_matching.h"
#include "spiral/outlines/rim_curve.h"
#include "taubin_curvature.h"

#include "geodesic/dijkstra_tree.h"
#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>
#include <pcl_spiral/search/impl/gabriel_edges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t segments = 128; // of a line
constexpr std::size_t matched_seeds = 64,
                      matched_candidates = 256; // of rim and inner loop; lines between them follow
constexpr double wave_in_spacings = 8.0;        // that Taubin smoothing halves
constexpr double wave_in_segments = 4.0;        // the same, at least
constexpr double fit_share = 0.2;               // of the chord error: tolerance of the B-spline

/** Where a line begins and ends, in order along the rim. */
struct Ends {
  Polyline starts, ends;
};

/** A loop reversed to have the surface on its right, from \p start. */
RimCurve
againstItsWay(const BoundaryLoop& loop, const Eigen::Vector3d& start)
{
  BoundaryLoop turned = loop;
  std::reverse(turned.curve.begin(), turned.curve.end());
  for (std::size_t& k : turned.corners)
    k = turned.curve.size() - 1 - k;
  return RimCurve(turned, start);
}

/** Partners of places at equal distances on the rim. */
Polyline
partnersOn(const BoundaryLoop& inner, const RimCurve& rim, std::size_t count)
{
  const RimCurve loop = againstItsWay(inner, inner.curve.front());
  const auto evenly = [](const RimCurve& curve, std::size_t points) {
    Polyline places;
    for (std::size_t k = 0; k < points; ++k)
      places.push_back(curve.at(curve.length() * static_cast<double>(k) / static_cast<double>(points)));
    return places;
  };
  std::vector<std::size_t> partner = matchLoops(evenly(rim, matched_seeds), evenly(loop, matched_candidates));
  partner.push_back(partner.front() + matched_candidates);
  Polyline partners;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i * matched_seeds) / static_cast<double>(count);
    const auto k = static_cast<std::size_t>(at);
    const double f = at - static_cast<double>(k);
    const double place = (1.0 - f) * static_cast<double>(partner[k]) + f * static_cast<double>(partner[k + 1]);
    partners.push_back(loop.at(loop.length() * std::fmod(place / matched_candidates, 1.0)));
  }
  return partners;
}

Status
shortestWays(const PublishedLineRequest& request, const NeighbourLists& edges, const Ends& ends, std::vector<GeodesicLine>& lines)
{
  const SurfaceGraph& graph = request.surface.graph();
  const auto count = static_cast<std::int64_t>(ends.ends.size());
  lines.assign(ends.ends.size(), GeodesicLine());
  if (!request.inner) {
    DijkstraTree tree;
    tree.compute(graph, edges, request.centre);
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t i = 0; i < count; ++i)
      lines[i].points = tree.path(ends.ends[i]);
  }
  else {
#pragma omp parallel
    {
      DijkstraTree tree;
#pragma omp for schedule(dynamic, 1)
      for (std::int64_t i = 0; i < count; ++i)
        if (tree.compute(graph, edges, ends.starts[i]))
          lines[i].points = tree.path(ends.ends[i]);
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].points.size() < 2)
      return {StatusCode::Failed, Diagnostic("no way over the edges of the elliptic Gabriel graph leads from ", Place(ends.starts[i]),
                                             " to the rim at ", Place(ends.ends[i]), ": the {scan} is disconnected between them")};
  return Status::success();
}

/** Make geodesics of the ways: (2)-(7), with (8)-(11) between the steps. */
Status
refine(const PublishedLineRequest& request, std::vector<GeodesicLine>& lines, PublishedLineReport& figures)
{
  RefinementOptions options;
  options.method = RefinementMethod::ConjugateGradientNewton;
  options.tolerance = request.chord_error;
  options.probe_normals = false;
  refineGeodesics(request.surface, options, lines);
  for (const GeodesicLine& line : lines) {
    if (line.left_surface)
      return {StatusCode::Failed,
              Diagnostic("the shortest line from ", Place(line.points.front()), " to the rim at ", Place(line.points.back()),
                         " leaves the surface at ", Place(line.left_at), ": the outline is re-entrant, or the {scan} has a gap")};
    figures.unsettled += !line.converged;
    figures.largest_move = std::max(figures.largest_move, line.largest_move);
  }
  return Status::success();
}

/** Taubin smoothing with fixed ends, then (8)-(11) again. */
Status
smooth(const PublishedLineRequest& request, std::vector<GeodesicLine>& lines)
{
  const double spacing = request.surface.graph().spacing();
  const auto count = static_cast<std::int64_t>(lines.size());
  std::vector<Polyline> smoothed(lines.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i) {
    TaubinOptions options;
    options.wavelength = std::max(wave_in_spacings * spacing, wave_in_segments * lines[i].length / segments);
    options.threads = 1;
    smoothed[i] = taubinSmoothed(lines[i].points, options);
  }
  std::vector<Eigen::Vector3d> queries;
  for (const Polyline& line : smoothed)
    queries.insert(queries.end(), line.begin(), line.end());
  std::vector<SurfaceFoot> feet;
  request.surface.project(queries, feet);
  auto foot = feet.begin();
  for (GeodesicLine& line : lines) {
    const Polyline given{line.points.front(), line.points.back()};
    line.feet.assign(foot, foot + static_cast<std::ptrdiff_t>(line.points.size()));
    foot += static_cast<std::ptrdiff_t>(line.points.size());
    line.feet.front().position = given.front();
    line.feet.back().position = given.back();
    for (const SurfaceFoot& f : line.feet)
      if (!f.valid)
        return {StatusCode::Failed, Diagnostic("a smoothed line leaves the surface at ", Place(f.position))};
  }
  return Status::success();
}

/** Equation (12) at the point of the cloud nearest to a foot; flat if that point has fewer than three
 *  neighbours. */
void
setCurvatures(const SurfaceGraph& graph, const NeighbourLists& edges, SurfaceFoot& foot)
{
  const PrincipalCurvatures k = taubinCurvatures(graph, edges, foot.nearest).value_or(PrincipalCurvatures());
  foot.curvature1 = k.larger;
  foot.curvature2 = k.smaller;
  foot.direction1 = k.direction;
}

/** Lines 0, 2^k, 2 2^k, ... come first, then those half-way between, and so on. The spiral leaves the later
 *  ones out near the centre, where the distance of lines is below their error. */
int
levelOf(std::size_t line, std::size_t count)
{
  constexpr std::size_t first_round = 16; // lines, at least
  int level = 0;
  for (std::size_t stride = 1; count / (2 * stride) >= first_round; stride *= 2)
    if (line % (2 * stride) != 0)
      ++level;
  return level;
}

Status
fit(const PublishedLineRequest& request, const NeighbourLists& edges, std::vector<GeodesicLine>& geodesics, std::vector<RadialLine>& lines)
{
  BSplineFitOptions options;
  options.tolerance = fit_share * request.chord_error;
  options.min_spans = 16;
  const auto count = static_cast<std::int64_t>(geodesics.size());
  lines.assign(geodesics.size(), RadialLine());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t i = 0; i < count; ++i) {
    RadialLine& line = lines[i];
    line.feet = std::move(geodesics[i].feet);
    Polyline points;
    for (SurfaceFoot& foot : line.feet) {
      points.push_back(foot.position);
      setCurvatures(request.surface.graph(), edges, foot);
    }
    if (const auto fitted = fitBSpline(points, options)) {
      line.curve = fitted->curve;
      line.deviation = fitted->max_deviation;
    }
    line.rim_share = line.turn_share = static_cast<double>(i) / static_cast<double>(count);
    line.level = levelOf(i, lines.size());
  }
  for (const RadialLine& line : lines)
    if (!(line.length() > 0.0))
      return {StatusCode::Failed, Diagnostic("no B-spline goes through the radial line that ends at ", Place(line.feet.back().position))};
  return Status::success();
}

} // namespace

std::size_t
publishedLineCount(double rim_length, double chord_error, double spacing)
{
  constexpr double fewest = 16.0, closest = 0.5; // of the spacing
  const double gap = stepFromChordError(2.0 * pi / rim_length, chord_error, rim_length);
  return static_cast<std::size_t>(std::ceil(std::max(fewest, rim_length / std::max(gap, closest * spacing))));
}

Status
publishedLines(const PublishedLineRequest& request, RadialLineSet& set, PublishedLineReport& figures)
{
  const SurfaceGraph& graph = request.surface.graph();
  const RimCurve rim(request.rim, request.start_point.value_or(request.rim.curve.front()));
  const std::size_t count = publishedLineCount(rim.length(), request.chord_error, graph.spacing());
  Ends ends;
  for (std::size_t i = 0; i < count; ++i)
    ends.ends.push_back(rim.at(rim.length() * static_cast<double>(i) / static_cast<double>(count)));
  ends.starts = request.inner ? partnersOn(*request.inner, rim, count) : Polyline(count, request.centre);
  const auto go_on = [&request](double share) { return !request.progress || request.progress(share); };
  const Status cancelled(StatusCode::Cancelled, "cancelled");

  const NeighbourLists edges = ellipticGabrielEdges(graph.blocks().points(), {}, GabrielOptions());
  std::vector<GeodesicLine> geodesics;
  if (const Status status = shortestWays(request, edges, ends, geodesics); !status.ok())
    return status;
  if (!go_on(0.3))
    return cancelled;
  if (const Status status = refine(request, geodesics, figures); !status.ok())
    return status;
  if (!go_on(0.9))
    return cancelled;
  if (const Status status = smooth(request, geodesics); !status.ok())
    return status;
  if (const Status status = fit(request, edges, geodesics, set.lines); !status.ok())
    return status;
  set.centre = request.centre;
  set.rim = rim.points();
  set.rim_corners = rim.corners();
  if (request.inner) {
    const RimCurve inner = againstItsWay(*request.inner, ends.starts.front());
    set.inner = inner.points();
    set.inner_corners = inner.corners();
    set.inner.front() = ends.starts.front();
  }
  return Status::success();
}

} // namespace pcl_spiral
