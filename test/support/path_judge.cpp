// SPDX-License-Identifier: BSD-3-Clause
#include "support/path_judge.h"

#include "support/path_faults.h"

#include <algorithm>

namespace pcl_spiral::test {

namespace {

/** Whether more than half of the samples in the gap are cut to within two heights, \p enough. */
bool
isOver(const Region& gap, const AnalyticSurface& surface, const std::vector<StockSample>& samples, double enough)
{
  std::size_t in = 0, cut = 0;
  for (const StockSample& s : samples)
    if (gap.contains(surface.chart(s.x))) {
      ++in;
      cut += s.stock <= enough ? 1 : 0;
    }
  return 2 * cut > in;
}

/** The true outlines, and the outline of the gap if the path leaves it out. */
std::vector<Polyline>
trueRims(const AnalyticSurface& surface, const JudgeSettings& settings, JudgedReport& f)
{
  std::vector<Polyline> rims = surface.outlines();
  f.over_gap = !settings.gap.empty() && isOver(Region({settings.gap}), surface, f.samples, 2.0 * settings.scallop_height);
  if (settings.gap.empty() || f.over_gap)
    return rims;
  rims.emplace_back();
  for (const Eigen::Vector2d& u : settings.gap)
    rims.back().push_back(surface.lift(u));
  return rims;
}

void
judgeHeights(const JudgedArea& area, const JudgedArea& whole, const CheckedPath& path, const JudgeSettings& s, JudgedReport& f)
{
  const std::vector<StockSample>& samples = f.samples;
  double deepest = 0.0;
  f.inside = heightFigures(samples, path, area, s.scallop_height, [&](std::size_t i) {
    const double rim = area.contains(samples[i].x) ? area.rimDistance(samples[i].x) : -1.0;
    deepest = std::max(deepest, rim);
    return rim >= s.margin * f.pitch;
  });
  f.turns = deepest / f.pitch;
  f.whole = heightFigures(samples, path, whole, s.scallop_height, [&](std::size_t i) { return whole.contains(samples[i].x); });
}

void
judgeOutside(const AnalyticSurface& surface, const JudgedArea& whole, const CheckedPath& path, JudgedReport& f)
{
  const Points points = atEqualSteps(path.contacts, 0.5 * f.pitch);
  std::size_t outside = 0;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d x = surface.pulled(p);
    const double beyond = whole.contains(x) ? 0.0 : whole.rimDistance(x);
    outside += beyond > 0.5 * f.pitch ? 1 : 0;
    if (beyond > f.outside.value)
      f.outside = {beyond, x, beyond, 0.0, 0};
  }
  f.outside_share = static_cast<double>(outside) / static_cast<double>(points.size());
}

void
judgeMotion(const AnalyticSurface& surface, const JudgedArea& area, const CheckedPath& path, const JudgeSettings& s, double longest,
            JudgedReport& f)
{
  f.length = lineLength(path.contacts);
  for (const std::size_t i : path.lifted_to)
    f.length -= (path.contacts[i] - path.contacts[i - 1]).norm();
  f.seconds = machineTime(path.contacts, s.speed, s.acceleration, 0.15 * f.pitch);
  f.turning = turningRadii(path.contacts, f.pitch);
  f.reversals = reversals(path.contacts, f.pitch);
  f.crossings = strictCrossings(surface, path, s.threads);
  f.jumps = jumps(path, longest);
  for (Place* place : {&f.turning.least, &f.turning.smallest, &f.reversals.first})
    place->rim = area.rimDistance(place->at);
  for (Place& jump : f.jumps)
    jump.rim = area.rimDistance(jump.at);
}

} // namespace

JudgedReport
judgedPath(const AnalyticSurface& surface, const std::vector<Polyline>& loops, const CheckedPath& path, const JudgeSettings& settings)
{
  JudgedReport f;
  f.pitch = exactStepOver(settings.tool_radius, settings.scallop_height, 0.0);
  if (path.size() < 2)
    return f;
  const double longest = settings.longest_move > 0.0 ? settings.longest_move : 1.001 * settings.tool_radius;
  const SweptBall ball{settings.tool_radius, settings.scallop_height, longest, settings.threads};
  f.samples = heightsLeft(surface, path, ball, settings.samples, settings.seed);
  const std::vector<Polyline> truth = trueRims(surface, settings, f);
  const JudgedArea whole(surface, truth);
  const JudgedArea area(surface, rimsAlong(truth, loops, 3.0 * settings.spacing, f.rims_missed));
  f.least = area.leastLength(settings.tool_radius, settings.scallop_height);
  f.least_true = whole.leastLength(settings.tool_radius, settings.scallop_height);
  judgeHeights(area, whole, path, settings, f);
  judgeOutside(surface, whole, path, f);
  judgeMotion(surface, area, path, settings, longest, f);
  return f;
}

} // namespace pcl_spiral::test
