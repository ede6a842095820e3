// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines along which loops must reach further, so that nothing stays uncovered.
 */
#pragma once

#include "ridge_climb.h"
#include "spiral/lines/segment_set.h"

#include <pcl_spiral/spiral/step_over_field.h>

#include <functional>
#include <vector>

namespace pcl_spiral {

/** Half the width of a finger, step-overs. */
constexpr double finger_radius = 0.3;
/** Cut off an axis at an end that is not within a loop, step-overs: a finger covers half a step-over beyond its edge, less a hundredth for
 *  what is not straight. Measured on the table of outlines with 0.42, 0.46 and 0.48 in place of 0.49: paths 0.1, 0.02 and 0.01 % longer,
 *  p99.9 of the scallops 1.0088, 1.0090 and 1.0090 h in place of 1.0094; with 0.50 one path gets bends sharper than 0.2. */
constexpr double finger_trim = finger_radius + 0.49;
/** A node farther from all loops than this is uncovered, step-overs. */
constexpr double covered_within = 0.504;

/** A line in the middle of a finger. */
struct FingerAxis {
  Polyline points;
  std::vector<StepOverMetric> metric;
};

/** The space between the loops of one level and the next. */
struct LevelGap {
  int level = 0;                    ///< of the lower loops
  std::vector<std::uint32_t> nodes; ///< of the band, between the two levels; ascending
  std::vector<std::uint32_t> necks; ///< on ridges within a loop of the next level that is narrower there than a finger; ascending
  std::vector<double> distances;    ///< of each of nodes from the loops of both levels; up to covered_within an upper limit
  std::function<bool(std::uint32_t)> is_ridge;         ///< whether gradients point apart about a node
  std::function<bool(std::uint32_t)> is_above;         ///< whether a node lies within a loop of the next level
  std::function<std::size_t(std::uint32_t)> loop_near; ///< the loop of the next level nearest to a node
};

/** Axes in the uncovered parts of \p gap: up along the ridge into the loop above. */
void findFingers(const StepOverDistance& field, const RidgeClimb& climb, const LevelGap& gap, std::vector<std::uint32_t>& scratch,
                 std::vector<FingerAxis>& axes);

/** Axes in cores. A core is a part without a loop of the next level. \p nodes: of one core, connected, with their \p distances from
 *  the loops about it. The axes are the longest way through the uncovered part, and its branches. */
void findCoreAxes(const StepOverDistance& field, const std::vector<std::uint32_t>& nodes, const std::vector<double>& distances,
                  std::vector<std::uint32_t>& scratch, std::vector<FingerAxis>& axes);

/** \p nodes, ascending, in connected groups, each ascending. \p scratch: a 0 for each node of the mesh, before and after the call. */
std::vector<std::vector<std::uint32_t>> connectedGroups(const Triangulation& triangles, const std::vector<std::uint32_t>& nodes,
                                                        std::vector<std::uint32_t>& scratch);

} // namespace pcl_spiral
