// SPDX-License-Identifier: BSD-3-Clause
#include "branch_passes.h"

#include "dot_fingers.h"

#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double whole_strip = 0.92;  // of a strip with a loop beside it: this share of it leaves no ridge
constexpr double closed_strip = 0.98; // the same of a loop that is a pass by itself
constexpr double neighbour = 1.35;    // step-overs
constexpr int probes = 4;             // along a strip

/** Whether a loop of the next level inside runs beside the strip. */
bool
hasInner(const LoopFinder& finder, const CutLoops& loops, const RampStrip& s)
{
  const ScallopLoop& loop = loops.loop(s.loop);
  for (int k = 0; k <= probes; ++k) {
    const double u = s.u - s.length * k / probes;
    if (finder.nearest(loop.level + 1, loop.at(u), loop.metricAt(u), neighbour).loop != LoopPlace::none)
      return true;
  }
  return false;
}

/** The deepest loop longer than \p shortest that is not joined, the longest of several; the number of loops if there is none. */
std::size_t
deepestLeft(const CutLoops& loops, const std::vector<std::uint8_t>& joined, double shortest)
{
  std::size_t deepest = loops.size();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const ScallopLoop& loop = loops.loop(i);
    if (joined[i] || loop.length() <= shortest)
      continue;
    if (deepest == loops.size() ||
        std::make_pair(loop.level, loop.length()) > std::make_pair(loops.loop(deepest).level, loops.loop(deepest).length()))
      deepest = i;
  }
  return deepest;
}

/** Add chains until every loop longer than \p shortest is joined. */
void
addChains(const LoopFinder& finder, double shortest, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path,
          std::vector<SpiralPass>& passes)
{
  for (std::size_t i = deepestLeft(loops, joined, shortest); i < loops.size(); i = deepestLeft(loops, joined, shortest)) {
    SpiralPass pass;
    pass.chain = findBranch(loops, finder, i, joined);
    for (const RampStrip& s : pass.chain)
      joined[s.loop] = 1;
    pass.cuts = addRamps(pass.chain, loops, path);
    pass.lead_in = loops.loop(pass.first().loop).level == 0 ? rim_overlap : whole_strip;
    pass.lead_out = hasInner(finder, loops, pass.last()) ? whole_strip : core_overlap;
    if (pass.chain.size() == 1) {
      pass.lead_in = closed_strip;
      pass.lead_out = 0.0;
    }
    passes.push_back(std::move(pass));
  }
}

} // namespace

std::vector<SpiralPass>
findBranches(const LoopFinder& finder, const Eigen::Vector3d& end, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path)
{
  std::vector<SpiralPass> left, passes;
  addChains(finder, longest_dot, joined, loops, path, left);
  reachDots(finder, joined, loops, path);
  addChains(finder, 0.0, joined, loops, path, left);
  Eigen::Vector3d here = end;
  while (!left.empty()) {
    const auto distance = [&](const SpiralPass& pass) { return (loops.loop(pass.first().loop).at(pass.beginArc()) - here).norm(); };
    auto nearest = left.begin();
    double least = std::numeric_limits<double>::infinity();
    for (auto it = left.begin(); it != left.end(); ++it)
      if (const double d = distance(*it); d < least) {
        least = d;
        nearest = it;
      }
    here = loops.loop(nearest->last().loop).at(nearest->endArc());
    passes.push_back(std::move(*nearest));
    left.erase(nearest);
  }
  return passes;
}

} // namespace pcl_spiral
