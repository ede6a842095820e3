#include <pcl_spiral/spiral/loop_linking.h>

#include "bridges.h"
#include "dot_fingers.h"
#include "loop_cuts.h"
#include "loop_finder.h"
#include "main_chain.h"

#include <pcl_spiral/common/message.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double core_overlap = 0.6; // share of the innermost strip that is travelled at the end
constexpr double grain = 0.1;        // step-overs

/** Part of a loop from \p from over \p length, appended to \p path. */
void
addPart(const ScallopLoop& loop, double from, double length, LinkedPath& path)
{
  const auto steps = static_cast<int>(length / grain) + 1;
  for (int k = 0; k <= steps; ++k) {
    path.points.push_back(loop.at(from + length * k / steps));
    path.metric.push_back(loop.metricAt(from + length * k / steps));
    path.reversed.push_back(0);
    path.turns.push_back((path.turns.empty() ? 0.0f : path.turns.back()) + static_cast<float>(k > 0 ? length / loop.length() / steps : 0.0));
  }
}

/** Points that fall together with the one before are left out. */
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

/** Of the chains from the innermost loop and from those that no loop lies in the one that meets the outer rim nearest to
 *  \p start. */
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

} // namespace

Status
linkLoops(const std::vector<ScallopLoop>& loops, LinkedPath& path, const std::optional<Eigen::Vector3d>& start)
{
  path = LinkedPath();
  CutLoops cuts(loops);
  const LoopFinder finder(loops);
  const std::size_t innermost = innermostOf(loops);
  const std::vector<RampStrip> chain = start ? chainNear(loops, finder, cuts, *start) : findMainChain(cuts, finder, innermost, 0, start);
  if (chain.empty())
    return {StatusCode::Failed, textOf("no way leads from the innermost loop at ", placeText(loops[innermost].points.front()),
                                       " out to the rim: the surface is too rough there for loops at constant scallop; smooth "
                                       "the scan, or choose the radial method (setMethod)")};
  const std::vector<std::size_t> ramps = addRamps(chain, cuts, path);
  path.chain_loops = chain.size();
  std::vector<std::uint8_t> joined(loops.size(), 0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const RampStrip &s = chain[i], &parent = chain[i > 0 ? i - 1 : 0];
    joined[s.loop] = 1;
    if (i > 0)
      path.joints.push_back(
          {s.loop, parent.loop, LoopJointKind::Ramp, loops[s.loop].at(s.u), loops[parent.loop].at(parent.u)});
  }
  const std::size_t left = joinLoops(finder, joined, cuts, path);
  if (left < loops.size())
    return {StatusCode::Failed, textOf("no loop runs beside the one at ", placeText(loops[left].points.front()), " of ",
                                       loops[left].length(), " step-overs: the path cannot be made in one piece there; choose "
                                       "the radial method (setMethod), or cut the part in pieces")};
  const RampStrip &first = chain.front(), &last = chain.back();
  addPart(loops[first.loop], first.u - rim_overlap * first.length, rim_overlap * first.length, path);
  if (!cuts.walk({ramps.front(), true}, path))
    return {StatusCode::Failed, textOf("the loops about ", placeText(loops[last.loop].points.front()),
                                       " could not be made into one path; choose the radial method (setMethod)")};
  addPart(loops[last.loop], last.u - last.length, core_overlap * last.length, path);
  dropRepeats(path);
  return Status::success();
}

} // namespace pcl_spiral
