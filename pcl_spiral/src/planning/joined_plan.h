// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Several regions as one plan.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/planning/spiral_plan.h>

#include <array>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The points of one region. */
struct RegionPoints {
  std::string name;
  std::vector<std::array<float, 3>> points;
};

/** InvalidInput if two \p regions have points in common: which, how many and where. */
Status checkApart(const std::vector<RegionPoints>& regions);

/** One path with all passes of \p regions, in their order, the tool lifted between them; points and reports together, in \p all, which has
 *  the whole scan already. Fails if regions have points in common. */
Status joinPlans(std::vector<SpiralPlan> regions, SpiralPlan& all);

/** Adds the time of \p stage to the stage of its name in \p stages, or puts it first. */
void addStage(const StageCost& stage, std::vector<StageCost>& stages);

} // namespace pcl_spiral
