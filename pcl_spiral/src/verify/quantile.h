// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Values at shares of the sorted order. Private to verify.
 */
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Nearest rank; reorders \p values. 0 if there are none. */
inline double
quantile(std::vector<float>& values, double share)
{
  if (values.empty())
    return 0.0;
  const double rank = std::max(0.0, std::ceil(share * static_cast<double>(values.size())) - 1.0);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

} // namespace pcl_spiral
