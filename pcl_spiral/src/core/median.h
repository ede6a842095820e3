// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The middle one of some values. Private.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** The value in the middle by size, of an even number the upper one; \p values are not empty. */
template <typename Value>
Value
medianOf(std::vector<Value> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace pcl_spiral
