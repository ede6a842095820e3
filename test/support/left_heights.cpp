// SPDX-License-Identifier: BSD-3-Clause
#include "support/left_heights.h"

#include "support/sampling.h"

#include <algorithm>
#include <cmath>

#include <omp.h>

namespace pcl_spiral::test {

namespace {

/** The sample at the share \p q of the order by height; reorders \p picked. */
std::size_t
ranked(const std::vector<StockSample>& samples, std::vector<std::size_t>& picked, double q)
{
  const double rank = std::ceil(q * static_cast<double>(picked.size())) - 1.0;
  const auto at = picked.begin() + static_cast<std::ptrdiff_t>(std::max(0.0, rank));
  std::nth_element(picked.begin(), at, picked.end(), [&](std::size_t a, std::size_t b) { return samples[a].stock < samples[b].stock; });
  return *at;
}

/** One pass of a path: the moves of the ball's centre, with the index of the first. */
struct Pass {
  MoveTree centres;
  std::size_t first;
};

std::vector<Pass>
passesOf(const CheckedPath& path, const SweptBall& ball)
{
  std::vector<Pass> passes;
  std::vector<Eigen::Vector3d> centres;
  for (std::size_t i = 0; i < path.size(); ++i) {
    centres.push_back(path.contacts[i] + ball.radius * path.normals[i]);
    if (i + 1 < path.size() && !path.isLift(i) && (path.contacts[i + 1] - path.contacts[i]).norm() <= ball.longest_move)
      continue;
    const std::size_t count = centres.size();
    passes.push_back({MoveTree(std::move(centres)), i + 1 - count});
    centres.clear();
  }
  return passes;
}

/** The least height that a pass leaves over \p x. */
StockSample
leastOver(const Eigen::Vector3d& x, const AnalyticSurface& surface, const std::vector<Pass>& passes, const SweptBall& ball)
{
  StockSample best{x, 20.0 * ball.h, 0, false};
  for (const Pass& pass : passes) {
    const StockSample s = StockField(surface, pass.centres, ball.radius, ball.h, 0.0).at(x);
    if (s.met && s.stock < best.stock)
      best = {x, s.stock, pass.first + s.move, true};
  }
  return best;
}

} // namespace

std::vector<StockSample>
heightsLeft(const AnalyticSurface& surface, const CheckedPath& path, const SweptBall& ball, std::size_t count, std::uint64_t seed)
{
  const std::vector<Pass> passes = passesOf(path, ball);
  const Sampled points = sampleUniform(surface, count, seed);
  std::vector<StockSample> samples(count);
  const int team = ball.threads > 0 ? ball.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic, 256) num_threads(team)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i) {
    const auto at = static_cast<std::size_t>(i);
    samples[at] = leastOver(points.points[at], surface, passes, ball);
  }
  return samples;
}

HeightReport
heightFigures(const std::vector<StockSample>& samples, const CheckedPath& path, const JudgedArea& area, double h,
              const std::function<bool(std::size_t)>& counts)
{
  HeightReport f;
  std::vector<std::size_t> picked;
  std::size_t over = 0, uncut = 0;
  const auto place = [&](std::size_t i) {
    const StockSample& s = samples[i];
    return Place{s.stock / h, s.x, area.rimDistance(s.x), path.turn(s.move), s.move};
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!counts(i))
      continue;
    picked.push_back(i);
    over += samples[i].stock > 1.05 * h ? 1 : 0;
    if (!samples[i].met && (uncut++ == 0 || area.rimDistance(samples[i].x) > f.uncut.rim))
      f.uncut = place(i);
    if (-samples[i].stock > f.gouge.value * h) {
      f.gouge = place(i);
      f.gouge.value = -f.gouge.value;
    }
  }
  f.samples = picked.size();
  if (picked.empty())
    return f;
  f.over_share = static_cast<double>(over) / static_cast<double>(picked.size());
  f.uncut_share = static_cast<double>(uncut) / static_cast<double>(picked.size());
  f.p99 = place(ranked(samples, picked, 0.99));
  f.p999 = place(ranked(samples, picked, 0.999));
  f.max = place(ranked(samples, picked, 1.0));
  return f;
}

} // namespace pcl_spiral::test
