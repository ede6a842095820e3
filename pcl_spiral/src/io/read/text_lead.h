// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The lines above the points of a text: titles, and the number of points.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "point_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** Lines of a text that are neither points nor the heading of the columns. */
struct TextLead {
  std::vector<std::size_t> passed; ///< numbers of these lines, rising
  Diagnostics titles;              ///< "line 1: 'Scan of part 7'" for each that is no number of points
  std::size_t count_line = 0;      ///< the line with the number of points; 0: none
  double count = 0.0;              ///< the number of points in it; of two numbers, rows and columns, their product
};

/** Whether the words name all of \p wanted, in upper or lower case, with or without quotes. */
bool namesAll(const std::vector<std::string_view>& words, const Names& wanted);

/** Looks at the lines of \p bytes before the first line with numbers for all \p wanted, from line \p skipped + 1 on. */
TextLead leadOf(std::string_view bytes, std::size_t skipped, const Names& wanted);

/** What to tell of \p titles; empty if there are none. */
Diagnostic titleWarning(const Diagnostics& titles);

} // namespace pcl_spiral
