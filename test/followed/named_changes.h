// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a message tells its reader to change.
 */
#pragma once

#include "refused_input.h"

#include "support/scratch_folder.h"

#include <string>
#include <vector>

namespace pcl_spiral::followed {

/** A command: options with their values, in the order they were given. */
using Command = std::vector<std::string>;

/** The commands that \p said names after \p command, in the order of its words. Polygons are written to \p folder. */
std::vector<Command> namedChanges(const RefusedInput& input, const Command& command, const std::string& said, const ScratchFolder& folder);

/** Whether \p said names a change that the planner has tried. */
bool plannerTried(const std::string& said);

/** Whether \p said leaves only another scan. */
bool onlyAnotherScan(const std::string& said);

} // namespace pcl_spiral::followed
