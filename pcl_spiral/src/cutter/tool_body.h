// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cutter as segments of a holder, to find what is in it. Private.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>

#include <vector>

namespace pcl_spiral {

/** Cones inside the cutter, from the tip to the top of its flank: of a corner 3e-4 of its radius are missing at most. */
std::vector<ToolSegment> cutterCones(const CutterProfile& cutter);

/** Length of a tool with \p holder, mm from the tip. Without one, a shank of shank_radii above the centre of the ball or corner. */
double toolLength(const CutterProfile& cutter, const std::vector<ToolSegment>& holder);

/** The cutter and, if the tool has no \p holder and is longer, a shank as wide up to \p length. */
HolderProfile cutterAndShank(const CutterProfile& cutter, const std::vector<ToolSegment>& holder, double length);

} // namespace pcl_spiral
