// SPDX-License-Identifier: BSD-3-Clause
#include "rim_reach.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** The longest loop of each part. */
std::vector<std::vector<std::uint32_t>>
outerLoops(const SurfaceGraph& graph, const Triangulation& mesh)
{
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  std::map<std::uint32_t, std::pair<double, std::vector<std::uint32_t>>> longest;
  for (const std::vector<std::uint32_t>& loop : mesh.boundaryLoops()) {
    double length = 0.0;
    for (const std::uint32_t h : loop)
      length += (graph.position(mesh.target(h)) - graph.position(mesh.origin(h))).norm();
    auto& found = longest[part[loop.front() / 3]];
    if (length > found.first)
      found = {length, loop};
  }
  std::vector<std::vector<std::uint32_t>> loops;
  loops.reserve(longest.size());
  for (auto& [part_of, loop] : longest)
    loops.push_back(std::move(loop.second));
  return loops;
}

/** Slope, radians, that cannot be told from level by the noise of the scan. */
double
leastSlope(const Surface& surface)
{
  constexpr double rounding = 1e-3, noises = 4.0, fitted = 5.0; // radians; standard deviations; spacings
  return rounding + noises * surface.noise() / (fitted * surface.spacing());
}

} // namespace

RimReach::RimReach(const Surface& surface, const Triangulation& mesh, const CutterShape& cutter, const SectionFrame& frame)
: frame_(frame), shortest_(0.5 * surface.spacing())
{
  const SurfaceGraph& graph = surface.graph();
  const CutterProfile profile(cutter);
  const Vector3d axis = frame.along.cross(frame.across);
  const double least_sine = std::sin(leastSlope(surface));
  for (const std::vector<std::uint32_t>& loop : outerLoops(graph, mesh)) {
    Polyline rim, tips;
    for (const std::uint32_t h : loop)
      rim.push_back(graph.position(mesh.origin(h)));
    std::vector<SurfaceFoot> feet;
    surface.fit().project(rim, feet);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vector3d normal = feet[i].valid ? feet[i].normal : Vector3d(graph.normal(mesh.origin(loop[i])));
      const CutterContact contact = profile.locate(rim[i], normal, axis);
      const bool slopes = normal.cross(axis).norm() > least_sine && normal.dot(axis) > 0.0;
      const Vector3d beside = contact.touches && slopes ? Vector3d(contact.tip - rim[i]) : Vector3d(Vector3d::Zero());
      tips.push_back(rim[i] + beside - beside.dot(axis) * axis);
    }
    rims_.push_back(std::move(rim));
    tips_.push_back(std::move(tips));
  }
}

void
RimReach::widen(double& low, double& high) const
{
  for (const Polyline& loop : tips_)
    for (const Vector3d& tip : loop) {
      low = std::min(low, across(tip));
      high = std::max(high, across(tip));
    }
}

RimReach::Spans
RimReach::inside(const std::vector<Polyline>& loops, double level) const
{
  std::vector<std::pair<double, Vector3d>> crossings;
  for (const Polyline& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double from = across(a) - level, to = across(b) - level;
      if ((from < 0.0) == (to < 0.0))
        continue;
      const Vector3d x = a + from / (from - to) * (b - a);
      crossings.emplace_back(along(x), x);
    }
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Spans spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    spans.push_back({crossings[i].first, crossings[i + 1].first, crossings[i].second, crossings[i + 1].second});
  return spans;
}

RimReach::Spans
RimReach::without(const Spans& spans, const Spans& covered)
{
  Spans left = spans;
  for (const Span& cover : covered) {
    Spans pieces;
    for (const Span& span : left) {
      if (cover.to <= span.from || cover.from >= span.to) {
        pieces.push_back(span);
        continue;
      }
      if (cover.from > span.from)
        pieces.push_back({span.from, cover.from, span.begin, cover.begin});
      if (cover.to < span.to)
        pieces.push_back({cover.to, span.to, cover.end, span.end});
    }
    left = std::move(pieces);
  }
  return left;
}

std::vector<DriveLine>
RimReach::beyond(double level, const std::vector<DriveLine>& lines) const
{
  constexpr double apart = 0.01; // of the span: joined lines share no point
  Spans covered;
  for (const DriveLine& line : lines) {
    const auto [first, last] = std::minmax_element(line.points.begin(), line.points.end(),
                                                   [this](const Vector3d& a, const Vector3d& b) { return along(a) < along(b); });
    covered.push_back({along(*first), along(*last), *first, *last});
  }
  std::vector<DriveLine> found;
  for (const Span& span : without(outerSpans(level), covered)) {
    if (span.to - span.from < shortest_)
      continue;
    const Vector3d way = span.end - span.begin;
    found.push_back({{span.begin + apart * way, span.end - apart * way}, false});
  }
  return found;
}

bool
RimReach::contains(const Vector3d& place) const
{
  const Spans spans = outerSpans(across(place));
  return std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return along(place) >= s.from && along(place) <= s.to; });
}

} // namespace pcl_spiral
