// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy.h"

#include "support/ideal_length.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::benchmarks {

Accuracy
accuracyOf(const RunCase& run, const pcl::PointCloud<ToolpathPoint>& path)
{
  const auto n = static_cast<std::ptrdiff_t>(path.size());
  const auto contact = [&path](std::ptrdiff_t i) -> Eigen::Vector3d {
    return path[static_cast<std::size_t>(i)].getVector3fMap().cast<double>();
  };
  Accuracy found;
  double largest = 0.0, squares = 0.0, longest = 0.0, length = 0.0;
#pragma omp parallel for schedule(static) reduction(max : largest, longest) reduction(+ : squares, length)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double off = std::abs(run.cloud.surface->signedDistance(contact(i)));
    const double move = i > 0 ? (contact(i) - contact(i - 1)).norm() : 0.0;
    largest = std::max(largest, off);
    squares += off * off;
    longest = std::max(longest, move);
    length += move;
  }
  found.deviation_max = largest;
  found.deviation_rms = n > 0 ? std::sqrt(squares / static_cast<double>(n)) : 0.0;
  found.longest_move = longest;
  if (run.round)
    found.length_ratio = length / test::lengthOverLatitudes(*run.cloud.surface, run.settings.tool_radius, run.settings.scallop_height);
  return found;
}

} // namespace pcl_spiral::benchmarks
