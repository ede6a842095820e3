// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path before it is put on the surface.
 */
#pragma once

#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/spiral/scallop_loop.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** How a loop is joined to another one. */
enum class LoopJointKind {
  Ramp,   ///< in the spiral from the rim to the innermost loop, inward
  Bridge, ///< to a loop beside the spiral, by a pair of narrow turns
  Lift,   ///< of the tool, from the end of one pass to the start of the next: with one_way instead of bridges
  Finger  ///< too small to travel: the other loop reaches out to its middle
};

/** One branch of the tree that links the loops. */
struct LoopJoint {
  std::size_t loop = 0;                                   ///< index in the given loops
  std::size_t parent = 0;                                 ///< the loop nearer to the rim's loop along the tree
  LoopJointKind kind = LoopJointKind::Bridge;             ///< how it is joined
  Eigen::Vector3d place = Eigen::Vector3d::Zero();        ///< on the loop, mm
  Eigen::Vector3d parent_place = Eigen::Vector3d::Zero(); ///< on the parent loop
};

/** A path before it is put on the surface. Parallel arrays; mm. */
struct LinkedPath {
  Polyline points;                         ///< in travel order
  std::vector<StepOverMetric> metric;      ///< one per point
  std::vector<float> turns;                ///< number of loops travelled so far
  std::vector<std::uint8_t> reversed;      ///< 1 where it travels against the sense of the rim's loop
  Polyline links;                          ///< places between the turns of ramps and near bridges, where coverage must be checked
  std::vector<StepOverMetric> link_metric; ///< one per place of links
  std::vector<std::size_t> passes;         ///< where the second and each later pass begins, with the tool lifted before; empty: one pass
  StepOverBasis basis;                     ///< of the loops
  std::vector<LoopJoint> joints;           ///< one for each loop except the rim's; parents before the loops joined to them, except fingers

  std::size_t chain_loops = 0; ///< in the spiral from the rim to the innermost loop
  std::size_t bridges = 0;     ///< further loops, each joined to a neighbour by a pair of turns
  std::size_t dots = 0;        ///< small loops that became a finger of a neighbour
};

} // namespace pcl_spiral
