// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Sheets of a surface closed by the ball. Private to cleaning.
 */
#pragma once

#include "closing_grid.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Numbers from 1 of the sheets of \p grid, one per node; 0: no sheet. Opened by a disc of half the \p radius of the
 *  ball: what hangs together by less is apart, and what is narrower is left out. */
std::vector<std::uint32_t> closedSheets(const ClosingGrid& grid, double radius);

} // namespace pcl_spiral
