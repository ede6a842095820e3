// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What files of moves refuse.
 */
#pragma once

#include <pcl_spiral/machine/tool_moves.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** \throw FileError without passes, or for a pass without moves */
void requireMoves(const std::string& file, const std::vector<ToolMoves>& passes);

} // namespace pcl_spiral
