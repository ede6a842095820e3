// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths and programs whose shank and holder touch nothing while the cutter cuts.
 */
#pragma once

#include "planning/tool_way.h"

#include <string>
#include <vector>

/** What is checked, of which file. */
struct PathCheck : pcl_spiral::ToolWay {
  std::string file; ///< for messages
  bool quiet = false;
};

/** Looks at the moves of \p passes, straight from pose to pose. Where only single points off the scan's surface are in their way, or
 *  collisions are accepted, that goes to \p warnings. \throw pcl_spiral::FileError, Cancelled */
void requireFreePath(const PathCheck& check, const std::vector<pcl_spiral::ToolPoses>& passes, pcl_spiral::Diagnostics& warnings);

/** The same for the cutting moves of \p program, as the machine makes them: with axes that are blended at its pole. */
void requireFreePath(const PathCheck& check, const pcl_spiral::MachineProgram& program, pcl_spiral::Diagnostics& warnings);
