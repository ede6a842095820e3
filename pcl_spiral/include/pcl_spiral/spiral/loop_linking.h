/** \file
 *  From closed loops to one continuous path.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/step_over_metric.h>
#include <pcl_spiral/spiral/scallop_loop.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A path before it is put on the surface. Parallel arrays; mm. */
struct LinkedPath {
  Polyline points;
  std::vector<StepOverMetric> metric;
  std::vector<float> turns;        ///< loops travelled so far
  std::vector<std::uint8_t> reversed; ///< 1 where it travels against the sense of the outer rim's loop
  Polyline links;                  ///< places between the turns of ramps and about bridges, where coverage is to be checked
  std::vector<StepOverMetric> link_metric;

  std::size_t chain_loops = 0; ///< of the spiral from the outer rim to the innermost loop
  std::size_t bridges = 0;     ///< further loops, joined to their neighbours by a pair of turns
  std::size_t dots = 0;        ///< small loops that became a finger of a neighbour
};

/** One path over all \p loops, which lie one inside the other one step-over apart, the outer rim first. From the outer rim it
 *  spirals inward to the innermost loop, in ramps one above the other. Each loop beside this chain (in other lobes, round
 *  holes) is joined to a neighbour by a bridge: both are cut side by side, and the ends are joined by two narrow turns, so that
 *  they are travelled as one. Fails where a loop has no neighbour that runs beside it. */
Status
linkLoops(const std::vector<ScallopLoop>& loops, LinkedPath& path);

} // namespace pcl_spiral
