// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The report of several regions together.
 */
#pragma once

#include <pcl_spiral/planning/spiral_plan.h>

#include <vector>

namespace pcl_spiral {

/** Sums of counts and lengths, the worst of what is measured, and all loops, lines, holes, places and warnings of \p regions, which are
 *  the passes of \p path. What only one region can have, such as the centre, is that of the first. */
SpiralReport joinedReport(const std::vector<SpiralPlan>& regions, const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral
