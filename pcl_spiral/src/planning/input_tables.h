// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tables of what planners take beside the settings that have a struct of their own.
 */
#pragma once

#include <pcl_spiral/planning/impl/drive_planning.h>
#include <pcl_spiral/planning/impl/ridge_planning.h>
#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <vector>

namespace pcl_spiral {

/** The measures of a cutter; \p radius: what its radius may be. */
std::vector<Setting> cutterTable(CutterShape& cutter, const NumberRange& radius);

/** No search comes near it; whole numbers of 32 bits hold it. */
constexpr double most_remedy_tries = 1e9;

/** How many paths a search for a change that helps may cost. */
Setting remedyTries(int& tries);

/** Of SpiralPlanner: flank, holder, collisions, closing by the ball, samples of a mesh. */
std::vector<Setting> settingTable(PlanInput& input);

/** Of DrivePlanner: outliers, collisions, the check of gouges, and the curve's end. */
std::vector<Setting> settingTable(DrivePlanInput& input);

/** Of RidgePlanner: outliers, collisions, and the ridge in a scan. */
std::vector<Setting> settingTable(RidgePlanInput& input);

} // namespace pcl_spiral
