// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The tool of a plan, for the checks of what it meets.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>

#include <vector>

namespace pcl_spiral {

/** What is led along passes and through the air, and by how much it may touch. Lengths in mm. */
struct LedTool {
  CutterShape cutter;              ///< radius 0: a beam
  std::vector<ToolSegment> holder; ///< above the cutter; none: a shank as wide as the cutter, without an end
  double holder_clearance = 0.0;   ///< that the holder keeps
  double tolerance = 0.05;         ///< how deep points may be in the tool
  unsigned int threads = 0;        ///< 0: all
  bool accepted = false;           ///< collisions are only warnings
};

} // namespace pcl_spiral
