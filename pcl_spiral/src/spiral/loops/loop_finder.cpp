// SPDX-License-Identifier: BSD-3-Clause
#include "loop_finder.h"

namespace pcl_spiral {

LoopFinder::LoopFinder(const std::vector<ScallopLoop>& loops) : loops_(loops)
{
  int levels = 0;
  for (const ScallopLoop& loop : loops)
    levels = std::max(levels, loop.level + 1);
  sets_.resize(levels);
  for (std::size_t i = 0; i < loops.size(); ++i)
    sets_[loops[i].level].add(loops[i].points, true, i);
#pragma omp parallel for schedule(dynamic)
  for (int level = 0; level < levels; ++level)
    if (!sets_[level].empty())
      sets_[level].build();
}

LoopPlace
LoopFinder::nearest(int level, const Eigen::Vector3d& p, const StepOverMetric& metric, double within, std::size_t but) const
{
  LoopPlace place;
  if (level < 0 || level >= levels() || sets_[level].empty())
    return place;
  const NearestSegment near = sets_[level].nearest(p, metric, within, but);
  if (near.segment == NearestSegment::none)
    return place;
  place.loop = sets_[level].label(near.segment);
  const ScallopLoop& loop = loops_[place.loop];
  const std::size_t i = sets_[level].place(near.segment);
  place.u = loop.arcs[i] + near.share * (loop.arcs[i + 1] - loop.arcs[i]);
  place.distance = near.distance;
  return place;
}

} // namespace pcl_spiral
