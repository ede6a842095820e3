// SPDX-License-Identifier: BSD-3-Clause
#include "raw_loops.h"

#include "spiral/field/finger_axes.h"
#include "spiral/lines/line_smoothing.h"

#include "graph/level_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double fine_step = 0.08;  // of a loop's points in the band, step-overs
constexpr double fine_width = 0.3;  // half the length over which its zigzag is smoothed there
constexpr double coarse_step = 0.4; // the same elsewhere, in edges of the mesh
constexpr double coarse_width = 1.2;
constexpr double straight_within = 0.002; // points this near to a straight line are left out, step-overs
constexpr double longest_straight = 4.0;
constexpr double shortest_loop = 0.5; // step-overs
constexpr double short_chord = 0.06;  // of a loop about a finger, step-overs: its radius is five times as long
constexpr double off_nodes = 1e-6;    // share of an edge: loops stay this far from its ends

/** Let the loop begin at the place farthest from its mean. Otherwise its begin, and all that is made of it, would depend on the order
 *  of the points of the mesh. */
std::vector<LevelCrossing>
fromFarthest(const StepOverMesh& mesh, std::vector<LevelCrossing> crossings)
{
  Polyline places;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const LevelCrossing& c : crossings) {
    places.push_back((1.0 - c.share) * mesh.positions[c.below] + c.share * mesh.positions[c.above]);
    mean += places.back() / static_cast<double>(crossings.size());
  }
  std::ptrdiff_t first = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if ((places[i] - mean).squaredNorm() > (places[first] - mean).squaredNorm())
      first = static_cast<std::ptrdiff_t>(i);
  std::rotate(crossings.begin(), crossings.begin() + first, crossings.end());
  return crossings;
}

/** Draws the loops of one level. */
class LoopTracer {
public:
  LoopTracer(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const std::vector<double>& values, int level,
             const RaisedField* raised)
  : field_(field), mesh_(field.mesh), band_(band), climb_(climb), values_(values), level_(level), raised_(raised)
  {}

  RawLoop loop(std::vector<LevelCrossing> crossings) const
  {
    for (LevelCrossing& c : crossings)
      if (isAtFinger(c))
        c.share = raised_->zero(placeAt(c.below), placeAt(c.above), values_[c.below] - level_, values_[c.above] - level_);
    crossings = fromFarthest(mesh_, std::move(crossings));
    RawLoop loop;
    loop.line.level = level_;
    loop.is_thin = true;
    loop.line.points.reserve(crossings.size());
    loop.line.metric.reserve(crossings.size());
    loop.uphill.reserve(crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const LevelCrossing &c = crossings[i], &next = crossings[(i + 1) % crossings.size()];
      const double share = std::clamp(c.share, off_nodes, 1.0 - off_nodes);
      add(c, between(placeAt(c.below), placeAt(c.above), share), loop);
      const std::uint32_t summit = climb_.summit(c.above);
      loop.is_thin = loop.is_thin && field_.distance[summit] < level_ + finger_radius;
      if (loop.summits.empty() || loop.summits.back() != summit)
        loop.summits.push_back(summit);
      if (isAtFinger(c) && isAtFinger(next))
        if (const auto bend = bendBetween(c, next))
          add(c, *bend, loop);
    }
    loop.line.measure();
    return loop;
  }

private:
  FieldPlace placeAt(std::uint32_t v) const { return {mesh_.positions[v], mesh_.metric[v], field_.distance[v]}; }

  void add(const LevelCrossing& c, const FieldPlace& place, RawLoop& loop) const
  {
    loop.line.points.push_back(place.point);
    loop.line.metric.push_back(place.metric);
    loop.uphill.push_back(mesh_.positions[c.above] - mesh_.positions[c.below]);
    loop.is_fine.push_back(field_.is_fine[c.below] && field_.is_fine[c.above]);
    loop.edge.push_back(std::max(field_.edge[c.below], field_.edge[c.above]));
    loop.is_near.push_back(band_.isNear(c.below) || band_.isNear(c.above));
  }

  /** Whether values on the edge are those of the raised field; about summits that a finger reaches they are lowered. */
  bool isAtFinger(const LevelCrossing& c) const
  {
    const double below = values_[c.below] - field_.distance[c.below], above = values_[c.above] - field_.distance[c.above];
    return raised_ && std::min(below, above) >= 0.0 && std::max(below, above) > 0.0;
  }

  /** Where the loop runs halfway between two crossings of the edges of a triangle: on the line from the node that the edges share through
   *  the middle of the chord. None for short chords, and where the loop leaves the triangle. */
  std::optional<FieldPlace> bendBetween(const LevelCrossing& c, const LevelCrossing& next) const
  {
    const bool is_below = c.below == next.below;
    if (is_below == (c.above == next.above))
      return std::nullopt;
    const std::uint32_t node = is_below ? c.below : c.above;
    const FieldPlace from = placeAt(node), a = placeAt(is_below ? c.above : c.below), b = placeAt(is_below ? next.above : next.below);
    const double s = is_below ? c.share : 1.0 - c.share, t = is_below ? next.share : 1.0 - next.share;
    const FieldPlace to = between(a, b, t / (s + t));
    if (from.metric.length(between(from, a, s).point - between(from, b, t).point) < short_chord)
      return std::nullopt;
    std::size_t last = NearestSegment::none;
    const double f_from = values_[node] - level_, f_to = raised_->at(to, last);
    if ((f_from < 0.0) == (f_to < 0.0))
      return std::nullopt;
    return is_below ? between(from, to, raised_->zero(from, to, f_from, f_to)) : between(to, from, raised_->zero(to, from, f_to, f_from));
  }

  const StepOverDistance& field_;
  const StepOverMesh& mesh_;
  const RidgeBand& band_;
  const RidgeClimb& climb_;
  const std::vector<double>& values_;
  int level_;
  const RaisedField* raised_;
};

} // namespace

std::vector<RawLoop>
traceLoops(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const std::vector<double>& values, int level,
           const std::vector<std::uint32_t>& triangles, const RaisedField* raised)
{
  const LoopTracer tracer(field, band, climb, values, level, raised);
  std::vector<RawLoop> loops;
  for (const LevelLine& line : levelLines(field.mesh.triangles, values, level, triangles)) {
    if (!line.closed || line.crossings.size() < 3)
      continue;
    RawLoop loop = tracer.loop(line.crossings);
    if (loop.line.length() > shortest_loop)
      loops.push_back(std::move(loop));
  }
  return loops;
}

std::unordered_set<std::uint32_t>
thinSummits(const std::vector<RawLoop>& loops)
{
  std::unordered_set<std::uint32_t> summits;
  for (const RawLoop& loop : loops)
    if (loop.is_thin)
      summits.insert(loop.summits.begin(), loop.summits.end());
  for (const RawLoop& loop : loops)
    if (!loop.is_thin)
      for (const std::uint32_t s : loop.summits)
        summits.erase(s);
  return summits;
}

ScallopLoop
finishedLoop(const RawLoop& loop)
{
  LineGrain grain;
  for (std::size_t i = 0; i < loop.is_fine.size(); ++i) {
    const double edge = loop.is_fine[i] ? 0.0 : loop.edge[i];
    grain.steps.push_back(std::max(fine_step, coarse_step * edge));
    grain.widths.push_back(std::max(fine_width, coarse_width * edge));
  }
  const ScallopLoop line = smoothed(loop.line, grain);
  ScallopLoop thin;
  thin.level = line.level;
  for (const std::size_t i : pointsKept(line, straight_within, longest_straight)) {
    thin.points.push_back(line.points[i]);
    thin.metric.push_back(line.metric[i]);
  }
  thin.measure();
  return thin;
}

void
addNearRuns(const ScallopLoop& loop, const std::vector<std::uint8_t>& is_near, std::size_t label, SegmentSet& set)
{
  const std::size_t n = loop.points.size();
  std::vector<std::uint8_t> wanted(n, 0);
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    wanted[i] = is_near[i] || is_near[(i + 1) % n] || is_near[(i + n - 1) % n];
    all = all && wanted[i];
  }
  if (all) {
    set.add(loop.points, true, label);
    return;
  }
  std::size_t first = 0;
  while (first < n && wanted[first])
    ++first;
  Polyline run;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (wanted[i])
      run.push_back(loop.points[i]);
    else if (!run.empty()) {
      set.add(run, false, label);
      run.clear();
    }
  }
}

} // namespace pcl_spiral
