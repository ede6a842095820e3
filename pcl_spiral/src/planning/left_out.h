// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Locations where the tool would enter what is not to be cut.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>

#include <pcl_spiral/cutter/tool_location.h>

#include <vector>

namespace pcl_spiral {

/** Marks as off the part the locations where the cutter enters a keep-out, or where the whole tool touches what stands in one or what
 *  was scanned beside the part, and those at the end of a move that does. For keep-outs the cutter is taken as a cylinder round its
 *  axis; a ball is taken as it is. Without a holder the tool is a shank ten radii long. Adds how many to \p plan. */
void leaveOut(const PassSettings& settings, std::vector<ToolLocations>& located, PassPlan& plan);

} // namespace pcl_spiral
