// SPDX-License-Identifier: BSD-3-Clause
#include "main_chain.h"

#include "chain_crossings.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double longest_ramp = 8.0;  // step-overs
constexpr double largest_share = 0.3; // of a loop
constexpr double largest_turn = 32.0; // degrees a strip may turn within 0.8 step-overs
constexpr double turn_reach = 0.4;
constexpr double farthest_step = 1.35; // to the next loop
/** The same where no chain is found: through a hollow as tight as the ball, loops lie farther apart than the metric beside it says. */
constexpr double step_through_hollow = 2.7;
constexpr std::size_t most_candidates = 90;
constexpr std::size_t ramp_points = 60;
constexpr int ramp_probes = 24;
constexpr double ramp_clearance = 0.2; // between a ramp and loops that it does not join
constexpr double cost_of_crossing = 50.0;
constexpr double cost_of_loop = 30.0; // cost of each loop that a branch leaves to another pass

/** The share of the way from one loop to the next that a ramp has done at the share \p t of its strip. */
double
rampShare(double t)
{
  return t * t * (3.0 - 2.0 * t);
}

/** Place of \p loop nearest to \p point, step-overs along it. */
double
nearestTo(const ScallopLoop& loop, const Eigen::Vector3d& point)
{
  double best = 0.0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Eigen::Vector3d& a = loop.points[i];
    const Eigen::Vector3d d = loop.points[(i + 1) % loop.points.size()] - a;
    const double share = std::clamp((point - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
    const double distance = (a + share * d - point).squaredNorm();
    if (distance < least) {
      least = distance;
      best = loop.arcs[i] + share * (loop.arcs[i + 1] - loop.arcs[i]);
    }
  }
  return best;
}

/** Chains from one loop outwards. */
class ChainFinder {
public:
  /** \p joined: null, or marks of loops; a chain ends before a marked loop. */
  ChainFinder(const CutLoops& loops, const LoopFinder& finder, const std::optional<Eigen::Vector3d>& start,
              const std::vector<std::uint8_t>* joined = nullptr, double farthest = farthest_step)
  : loops_(loops), finder_(finder), start_(start), joined_(joined), farthest_(farthest), bends_(loops.size())
  {}

  std::vector<RampStrip> best(std::size_t innermost, std::size_t outer_rim)
  {
    loops_at_.assign(finder_.levels(), 0);
    const auto count = static_cast<std::int64_t>(loops_.size());
    for (std::int64_t i = 0; i < count; ++i)
      ++loops_at_[loops_.loop(i).level];
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t i = 0; i < count; ++i)
      if (!isJoined(i))
        findBends(i);
    const double whole = loops_.loop(innermost).length(), from = start_ ? nearestTo(loops_.loop(innermost), *start_) : 0.0;
    const auto starts = static_cast<std::int64_t>(std::clamp<double>(whole / 0.1, 8.0, static_cast<double>(most_candidates)));
    const std::vector<double> drifts = start_ ? std::vector<double>{0.0, 0.6, 1.5, 3.0, 5.0, 8.0} : std::vector<double>{0.0, 0.6};
    const std::int64_t tries = starts * static_cast<std::int64_t>(drifts.size());
    std::vector<std::vector<RampStrip>> chains(tries);
    std::vector<double> scores(chains.size(), std::numeric_limits<double>::infinity());
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t c = 0; c < tries; ++c) {
      chains[c] = walk({innermost, from + whole * static_cast<double>(c % starts) / static_cast<double>(starts)}, drifts[c / starts]);
      if (!chains[c].empty())
        scores[c] = score(chains[c]) + farness(chains[c]) + (joined_ || chains[c].back().loop == outer_rim ? 0.0 : 1000.0);
    }
    if (joined_)
      preferLong(chains, scores);
    for (std::vector<RampStrip>& chain : chains)
      std::reverse(chain.begin(), chain.end());
    return chains[clearest(chains, scores)];
  }

private:
  bool isJoined(std::size_t i) const
  {
    return joined_ && (*joined_)[i] != 0;
  }
  /** Prefer chains over many loops: shorter ones leave more to other passes. */
  static void preferLong(const std::vector<std::vector<RampStrip>>& chains, std::vector<double>& scores)
  {
    std::size_t most = 0;
    for (const std::vector<RampStrip>& chain : chains)
      most = std::max(most, chain.size());
    for (std::size_t c = 0; c < chains.size(); ++c)
      scores[c] += cost_of_loop * static_cast<double>(most - chains[c].size());
  }
  /** The chain of least score whose ramps cross nothing; if all cross something, the one with the fewest crossings. */
  std::size_t clearest(const std::vector<std::vector<RampStrip>>& chains, const std::vector<double>& scores) const
  {
    std::vector<std::size_t> order(chains.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&scores](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
    std::size_t best = order.front(), fewest = std::numeric_limits<std::size_t>::max();
    for (const std::size_t i : order) {
      if (chains[i].empty() || scores[i] >= 1000.0)
        break;
      const std::size_t crossings = chainCrossings(loops_, chains[i]);
      if (crossings < fewest) {
        fewest = crossings;
        best = i;
      }
      if (crossings == 0)
        break;
    }
    return best;
  }
  /** Find places where a loop bends too sharply for a strip, ascending. */
  void findBends(std::size_t i)
  {
    const ScallopLoop& loop = loops_.loop(i);
    if (loop.length() <= 7.0)
      return;
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const Eigen::Vector3d before = loop.at(loop.arcs[k] - turn_reach), after = loop.at(loop.arcs[k] + turn_reach);
      const double turn =
          std::acos(std::clamp((loop.points[k] - before).normalized().dot((after - loop.points[k]).normalized()), -1.0, 1.0));
      if (turn > largest_turn * pi / 180.0)
        bends_[i].push_back(loop.arcs[k]);
    }
  }
  /** From \p u to the next bend behind it, or before it with \p ahead. */
  double clearance(std::size_t i, double u, bool ahead) const
  {
    const ScallopLoop& loop = loops_.loop(i);
    const std::vector<double>& bends = bends_[i];
    if (bends.empty())
      return loop.length();
    const double w = loop.wrapped(u);
    const auto after = std::lower_bound(bends.begin(), bends.end(), w);
    if (ahead)
      return after == bends.end() ? bends.front() + loop.length() - w : *after - w;
    return after == bends.begin() ? w + loop.length() - bends.back() : w - *(after - 1);
  }
  double longest(std::size_t i, double u) const
  {
    return std::max(0.15, std::min({longest_ramp, largest_share * loops_.loop(i).length(), 0.85 * clearance(i, u, false)}));
  }

  std::vector<RampStrip> walk(LoopPlace start, double drift) const
  {
    std::vector<RampStrip> chain{{start.loop, start.u, longest(start.loop, start.u), 0.0}};
    for (int level = loops_.loop(start.loop).level - 1; level >= 0; --level) {
      const RampStrip& strip = chain.back();
      const ScallopLoop& loop = loops_.loop(strip.loop);
      const LoopPlace left = finder_.nearest(level, loop.at(strip.u), loop.metricAt(strip.u), farthest_);
      if (joined_ && (left.loop == LoopPlace::none || isJoined(left.loop)))
        break;
      if (left.loop == LoopPlace::none)
        return {};
      const double from = strip.u - strip.length;
      const LoopPlace right = finder_.nearest(level, loop.at(from), loop.metricAt(from), 2.0 * farthest_);
      const ScallopLoop& next = loops_.loop(left.loop);
      double wide = right.loop == left.loop ? next.wrapped(left.u - right.u) : 0.0;
      if (wide > 0.6 * next.length())
        wide = 0.0;
      double length = longest(left.loop, left.u);
      // On the way in, both ends of a strip may only move forward, or turns would spread apart.
      double u = wide >= length ? left.u - wide + length : left.u;
      u -= drift * 0.1 * length;
      length = std::min(length, longest(left.loop, u));
      chain.push_back({left.loop, next.wrapped(u), length, left.distance});
    }
    return chain;
  }

  /** Distance between the given place and the place where a chain meets the rim: it counts more than how even the chain is. */
  double farness(const std::vector<RampStrip>& chain) const
  {
    if (!start_)
      return 0.0;
    const RampStrip& rim = chain.back();
    const double off = loops_.loop(rim.loop).metricAt(rim.u).length(loops_.loop(rim.loop).at(rim.u - rim_overlap * rim.length) - *start_);
    return 800.0 * std::min(1.0, off / loops_.loop(rim.loop).length());
  }

  double score(const std::vector<RampStrip>& chain) const
  {
    double sum = 0.0;
    for (const RampStrip& s : chain) {
      const double wanted = std::min(longest_ramp, largest_share * loops_.loop(s.loop).length());
      sum += std::max(0.0, wanted - s.length) / wanted + 3.0 * std::max(0.0, s.distance - 1.1);
      if (loops_.loop(s.loop).length() > 3.0 && clearance(s.loop, s.u, true) < 0.4)
        sum += 2.0;
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (i >= 2 || chain.size() <= 4)
        sum += 3.0 * unevenness(chain[i], chain[i + 1]);
      if (!isClear(chain[i + 1], chain[i]))
        sum += cost_of_crossing;
    }
    return sum;
  }
  /** Whether the ramp from \p a in to \p b stays clear of the other loops of their levels. */
  bool isClear(const RampStrip& a, const RampStrip& b) const
  {
    for (const std::size_t own : {a.loop, b.loop}) {
      const int level = loops_.loop(own).level;
      if (loops_at_[level] < 2)
        continue;
      for (int k = 0; k <= ramp_probes; ++k) {
        const double t = static_cast<double>(k) / ramp_probes;
        if (finder_.nearest(level, onRamp(loops_, a, b, t), loops_.loop(own).metricAt(own == a.loop ? a.u : b.u), ramp_clearance, own)
                .loop != LoopPlace::none)
          return false;
      }
    }
    return true;
  }
  /** How much two strips differ from the ideal: side by side, about one step-over apart. */
  double unevenness(const RampStrip& a, const RampStrip& b) const
  {
    double least = 1e30, most = 0.0;
    for (int i = 0; i <= 6; ++i) {
      const double ua = a.u - a.length * (1.0 - i / 6.0), ub = b.u - b.length * (1.0 - i / 6.0);
      const double d = loops_.loop(b.loop).metricAt(ub).length(loops_.loop(a.loop).at(ua) - loops_.loop(b.loop).at(ub));
      least = std::min(least, d);
      most = std::max(most, d);
    }
    return (least < 0.5 ? 1.0 : 0.0) + (most > 1.7 ? 1.0 : 0.0);
  }

  const CutLoops& loops_;
  const LoopFinder& finder_;
  std::optional<Eigen::Vector3d> start_;
  const std::vector<std::uint8_t>* joined_;
  double farthest_; ///< step-overs to the next loop
  std::vector<std::vector<double>> bends_;
  std::vector<std::size_t> loops_at_; ///< of each level
};

} // namespace

Eigen::Vector3d
onRamp(const CutLoops& loops, const RampStrip& a, const RampStrip& b, double t)
{
  const double share = rampShare(t);
  return (1.0 - share) * loops.loop(a.loop).at(a.u - a.length * (1.0 - t)) + share * loops.loop(b.loop).at(b.u - b.length * (1.0 - t));
}

std::vector<RampStrip>
findMainChain(const CutLoops& loops, const LoopFinder& finder, std::size_t innermost, std::size_t outer_rim,
              const std::optional<Eigen::Vector3d>& start)
{
  std::vector<RampStrip> chain = ChainFinder(loops, finder, start).best(innermost, outer_rim);
  if (chain.empty())
    chain = ChainFinder(loops, finder, start, nullptr, step_through_hollow).best(innermost, outer_rim);
  return chain;
}

std::vector<RampStrip>
findBranch(const CutLoops& loops, const LoopFinder& finder, std::size_t innermost, const std::vector<std::uint8_t>& joined)
{
  return ChainFinder(loops, finder, std::nullopt, &joined).best(innermost, LoopPlace::none);
}

std::vector<std::size_t>
addRamps(const std::vector<RampStrip>& chain, CutLoops& loops, LinkedPath& path)
{
  std::vector<std::size_t> cuts;
  cuts.reserve(chain.size());
  for (const RampStrip& s : chain)
    cuts.push_back(loops.addCut({s.loop, s.u - s.length, s.length}));
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const RampStrip &a = chain[i], &b = chain[i + 1];
    const ScallopLoop &from = loops.loop(a.loop), &to = loops.loop(b.loop);
    PathPiece piece;
    for (std::size_t k = 1; k < ramp_points; ++k) {
      const double t = static_cast<double>(k) / ramp_points, s = rampShare(t);
      const double ua = a.u - a.length * (1.0 - t), ub = b.u - b.length * (1.0 - t);
      const auto place = [&](double share) -> Eigen::Vector3d { return (1.0 - share) * from.at(ua) + share * to.at(ub); };
      piece.add(place(s), between(from.metricAt(ua), to.metricAt(ub), s));
      if (k % 3 == 0)
        for (const double share : {0.25, 0.5, 0.75}) {
          path.links.push_back(place(share));
          path.link_metric.push_back(between(from.metricAt(ua), to.metricAt(ub), share));
        }
    }
    loops.connect({cuts[i], false}, {cuts[i + 1], true}, std::move(piece));
  }
  return cuts;
}

} // namespace pcl_spiral
