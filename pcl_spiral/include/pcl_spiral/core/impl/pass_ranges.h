// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The passes of a path; the tool is lifted between them.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Points of one pass: from begin to the one before end. */
struct PassRange {
  std::size_t begin = 0, end = 0;
};

/** The passes of a path of \p points points; \p begins: where the second and each later pass begins. */
inline std::vector<PassRange>
passRanges(const std::vector<std::size_t>& begins, std::size_t points)
{
  std::vector<PassRange> ranges{{0, points}};
  for (const std::size_t begin : begins) {
    ranges.back().end = begin;
    ranges.push_back({begin, points});
  }
  return ranges;
}

/** The pass that point \p i belongs to, counted from 0. */
inline std::size_t
passOf(const std::vector<std::size_t>& begins, std::size_t i)
{
  return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), i) - begins.begin());
}

/** True if a pass other than the first begins at point \p i: the move to it is a lift. */
inline bool
beginsPass(const std::vector<std::size_t>& begins, std::size_t i)
{
  return std::binary_search(begins.begin(), begins.end(), i);
}

} // namespace pcl_spiral
