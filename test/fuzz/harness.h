// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The rule for every fuzzed reader: it returns a complete table in proportion to its bytes, or throws a FileError.
 */
#pragma once

#include "../../pcl_spiral/src/io/read/point_table.h"

#include <pcl_spiral/io/file_error.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace pcl_spiral {

/** Runs \p read on the bytes; ends the program if the result is not a table of \p columns, all of the same length,
 *  with at least one row and at most one row per byte. Any exception except FileError ends the program. */
template <typename Read>
int
fuzzTable(const std::uint8_t* data, std::size_t size, std::size_t columns, Read read)
{
  try {
    const PointTable table = read(std::string_view(reinterpret_cast<const char*>(data), size));
    if (table.size() != columns || table[0].empty() || table[0].size() > size)
      std::abort();
    for (const std::vector<double>& column : table)
      if (column.size() != table[0].size())
        std::abort();
  }
  catch (const FileError&) {
  }
  return 0;
}

} // namespace pcl_spiral
