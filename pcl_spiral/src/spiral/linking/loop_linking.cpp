// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/loop_linking.h>

#include "branch_passes.h"
#include "bridges.h"
#include "dot_fingers.h"
#include "loop_cuts.h"
#include "main_chain.h"
#include "spiral/loops/loop_finder.h"
#include "spiral/path/given_path.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double grain = 0.1; // step-overs

/** Part of a loop from \p from over \p length, appended to \p path. */
void
addPart(const ScallopLoop& loop, double from, double length, LinkedPath& path)
{
  const auto steps = static_cast<int>(length / grain) + 1;
  for (int k = 0; k <= steps; ++k) {
    path.points.push_back(loop.at(from + length * k / steps));
    path.metric.push_back(loop.metricAt(from + length * k / steps));
    path.reversed.push_back(0);
    path.turns.push_back((path.turns.empty() ? 0.0f : path.turns.back()) +
                         static_cast<float>(k > 0 ? length / loop.length() / steps : 0.0));
  }
}

/** Remove points that coincide with the one before. */
void
dropRepeats(LinkedPath& path)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (kept > 0 && path.metric[i].length(path.points[i] - path.points[kept - 1]) < 1e-4)
      continue;
    path.points[kept] = path.points[i];
    path.metric[kept] = path.metric[i];
    path.reversed[kept] = path.reversed[i];
    path.turns[kept] = path.turns[i];
    ++kept;
  }
  path.points.resize(kept);
  path.metric.resize(kept);
  path.reversed.resize(kept);
  path.turns.resize(kept);
  path.points.shrink_to_fit();
  path.metric.shrink_to_fit();
}

/** The deepest loop, of several the longest. */
std::size_t
innermostOf(const std::vector<ScallopLoop>& loops)
{
  std::size_t innermost = 0;
  for (std::size_t i = 1; i < loops.size(); ++i)
    if (std::make_pair(loops[i].level, loops[i].length()) > std::make_pair(loops[innermost].level, loops[innermost].length()))
      innermost = i;
  return innermost;
}

/** The chain that meets the outer rim nearest to \p start. Chains begin at the innermost loop and at every loop without a loop
 *  inside. */
std::vector<RampStrip>
chainNear(const std::vector<ScallopLoop>& loops, const LoopFinder& finder, const CutLoops& cuts, const Eigen::Vector3d& start)
{
  constexpr double next_loop = 1.35; // step-overs
  std::vector<std::uint8_t> has_inner(loops.size(), 0);
  for (const ScallopLoop& loop : loops)
    for (std::size_t k = 0; k < 8; ++k) {
      const double u = loop.length() * static_cast<double>(k) / 8.0;
      const LoopPlace outer = finder.nearest(loop.level - 1, loop.at(u), loop.metricAt(u), next_loop);
      if (outer.loop != LoopPlace::none)
        has_inner[outer.loop] = 1;
    }
  const std::size_t innermost = innermostOf(loops);
  std::vector<RampStrip> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i != innermost && (has_inner[i] || loops[i].length() <= longest_dot))
      continue;
    std::vector<RampStrip> chain = findMainChain(cuts, finder, i, 0, start);
    if (chain.empty() || chain.front().loop != 0)
      continue;
    const RampStrip& rim = chain.front();
    const double off = (loops[0].at(rim.u - rim_overlap * rim.length) - start).norm();
    if (off < least) {
      least = off;
      best = std::move(chain);
    }
  }
  return best;
}

/** Record how the loops of a chain are joined. */
void
addJoints(const std::vector<RampStrip>& chain, const CutLoops& loops, std::vector<std::uint8_t>& joined, LinkedPath& path)
{
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const RampStrip &s = chain[i], &parent = chain[i > 0 ? i - 1 : 0];
    joined[s.loop] = 1;
    if (i > 0)
      path.joints.push_back({s.loop, parent.loop, LoopJointKind::Ramp, loops.loop(s.loop).at(s.u), loops.loop(parent.loop).at(parent.u)});
  }
}

/** Append a pass to \p path. \return the number of arcs between cuts on it. */
std::size_t
addPass(const SpiralPass& pass, const CutLoops& loops, LinkedPath& path)
{
  LinkedPath piece;
  const RampStrip &first = pass.first(), &last = pass.last();
  addPart(loops.loop(first.loop), pass.beginArc(), pass.lead_in * first.length, piece);
  const std::size_t arcs = loops.walk({pass.cuts.front(), true}, piece);
  if (pass.lead_out > 0.0)
    addPart(loops.loop(last.loop), last.u - last.length, pass.lead_out * last.length, piece);
  dropRepeats(piece);
  if (path.points.empty()) {
    path.points = std::move(piece.points);
    path.metric = std::move(piece.metric);
    path.reversed = std::move(piece.reversed);
    path.turns = std::move(piece.turns);
    return arcs;
  }
  const float before = path.turns.back();
  path.passes.push_back(path.points.size());
  path.points.insert(path.points.end(), piece.points.begin(), piece.points.end());
  path.metric.insert(path.metric.end(), piece.metric.begin(), piece.metric.end());
  path.reversed.insert(path.reversed.end(), piece.reversed.begin(), piece.reversed.end());
  for (const float turn : piece.turns)
    path.turns.push_back(before + turn);
  return arcs;
}

/** The loops beside the first of \p passes as further passes. */
void
addBranches(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& cuts, LinkedPath& path, std::vector<SpiralPass>& passes)
{
  const auto place = [&cuts](const RampStrip& s, double arc) { return cuts.loop(s.loop).at(arc); };
  for (SpiralPass& pass : findBranches(finder, place(passes[0].last(), passes[0].endArc()), joined, cuts, path)) {
    const SpiralPass& before = passes.back();
    path.joints.push_back({pass.first().loop, before.last().loop, LoopJointKind::Lift, place(pass.first(), pass.beginArc()),
                           place(before.last(), before.endArc())});
    addJoints(pass.chain, cuts, joined, path);
    passes.push_back(std::move(pass));
  }
}

} // namespace

Status
linkLoops(const std::vector<ScallopLoop>& loops, LinkedPath& path, const std::optional<Eigen::Vector3d>& start, bool one_way)
{
  path = LinkedPath();
  if (const Status status = checkGiven(loops.size(), "the set of loops"); !status.ok())
    return status;
  path.basis = loops.front().basis;
  CutLoops cuts(loops);
  auto finder = std::make_unique<const LoopFinder>(loops);
  const std::size_t innermost = innermostOf(loops);
  std::vector<SpiralPass> passes(1);
  passes[0].chain = start ? chainNear(loops, *finder, cuts, *start) : findMainChain(cuts, *finder, innermost, 0, start);
  if (passes[0].chain.empty())
    return {StatusCode::Failed, Diagnostic("no chain of loops leads from the innermost loop at ", Place(loops[innermost].points.front()),
                                           " out to the rim: the surface is too rough there for loops at constant scallop; smooth "
                                           "the {scan}, or choose the radial method ({setMethod})")};
  passes[0].cuts = addRamps(passes[0].chain, cuts, path);
  passes[0].lead_in = rim_overlap;
  passes[0].lead_out = core_overlap;
  path.chain_loops = passes[0].chain.size();
  std::vector<std::uint8_t> joined(loops.size(), 0);
  addJoints(passes[0].chain, cuts, joined, path);
  if (one_way)
    addBranches(*finder, joined, cuts, path, passes);
  else if (const std::size_t left = joinLoops(*finder, joined, cuts, path); left < loops.size())
    return {StatusCode::Failed,
            Diagnostic("no loop runs beside the one at ", Place(loops[left].points.front()), ", which is ", loops[left].length(),
                       " step-overs long: the path cannot be made in one piece there; choose "
                       "the radial method ({setMethod}), or cut the part into pieces")};
  finder.reset(); // larger than the path
  std::size_t arcs = 0;
  for (const SpiralPass& pass : passes)
    arcs += addPass(pass, cuts, path);
  if (arcs != cuts.cuts())
    return {StatusCode::Failed, Diagnostic("the loops about ", Place(loops[passes[0].last().loop].points.front()),
                                           " could not be joined into one path; choose the radial method ({setMethod})")};
  return Status::success();
}

} // namespace pcl_spiral
