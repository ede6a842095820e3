// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_check.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>

namespace pcl_spiral {

void
requireMoves(const std::string& file, const std::vector<ToolMoves>& passes)
{
  if (passes.empty() || std::any_of(passes.begin(), passes.end(), [](const ToolMoves& moves) { return moves.empty(); }))
    throw FileError(file, "not written: a pass has no moves; make the moves with ledPasses");
}

} // namespace pcl_spiral
