// SPDX-License-Identifier: BSD-3-Clause
#include "raw_loops.h"

#include "spiral/field/finger_axes.h"
#include "spiral/lines/line_smoothing.h"

#include "graph/level_lines.h"

#include <algorithm>
#include <cmath>
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

RawLoop
rawLoop(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const LevelLine& line, int level)
{
  const StepOverMesh& mesh = field.mesh;
  RawLoop loop;
  loop.line.level = level;
  loop.is_thin = true;
  loop.line.points.reserve(line.crossings.size());
  loop.line.metric.reserve(line.crossings.size());
  loop.uphill.reserve(line.crossings.size());
  for (const LevelCrossing& c : fromFarthest(mesh, line.crossings)) {
    const double share = std::clamp(c.share, off_nodes, 1.0 - off_nodes);
    loop.line.points.push_back((1.0 - share) * mesh.positions[c.below] + share * mesh.positions[c.above]);
    loop.line.metric.push_back(between(mesh.metric[c.below], mesh.metric[c.above], share));
    loop.uphill.push_back(mesh.positions[c.above] - mesh.positions[c.below]);
    loop.is_fine.push_back(field.is_fine[c.below] && field.is_fine[c.above]);
    loop.is_cut.push_back(field.is_cut[c.below] && field.is_cut[c.above]);
    loop.is_near.push_back(band.isNear(c.below) || band.isNear(c.above));
    const std::uint32_t summit = climb.summit(c.above);
    loop.is_thin = loop.is_thin && field.distance[summit] < level + finger_radius;
    if (loop.summits.empty() || loop.summits.back() != summit)
      loop.summits.push_back(summit);
  }
  loop.line.measure();
  return loop;
}

} // namespace

std::vector<RawLoop>
traceLoops(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb, const std::vector<double>& values, int level,
           const std::vector<std::uint32_t>& triangles)
{
  std::vector<RawLoop> loops;
  for (const LevelLine& line : levelLines(field.mesh.triangles, values, level, triangles)) {
    if (!line.closed || line.crossings.size() < 3)
      continue;
    RawLoop loop = rawLoop(field, band, climb, line, level);
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
finishedLoop(const StepOverDistance& field, const RawLoop& loop)
{
  LineGrain grain;
  for (std::size_t i = 0; i < loop.is_fine.size(); ++i) {
    const double edge = loop.is_fine[i] ? 0.0 : loop.is_cut[i] ? field.cut_edge : field.usual_edge;
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
