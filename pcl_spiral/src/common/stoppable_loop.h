// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A parallel loop that can be cancelled.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pcl_spiral {

/** Points worked on between two reports of progress, where a run can be cancelled. */
constexpr std::size_t report_chunk = 1u << 16;

/** Call \p body(i) for all i from \p first to below \p end, in any order and in parallel. \p progress: called with the share done after
 *  every report_chunk of them; false cancels. \p size: how many of these one call does the work of. A single call leaves the threads to
 *  loops in \p body. Returns false if cancelled. */
template <typename Body>
bool
stoppableLoop(std::int64_t first, std::int64_t end, const std::function<bool(double)>& progress, const Body& body, std::int64_t size = 1)
{
  const std::int64_t together = std::max<std::int64_t>(1, report_chunk / size), shared_out = std::max<std::int64_t>(1, 256 / size);
  for (std::int64_t begin = first; begin < end; begin += together) {
    if (progress && !progress(static_cast<double>(begin - first) / static_cast<double>(end - first)))
      return false;
    const std::int64_t stop = std::min(end, begin + together);
#pragma omp parallel for schedule(dynamic, shared_out) if (stop - begin > 1)
    for (std::int64_t i = begin; i < stop; ++i)
      body(i);
  }
  return true;
}

} // namespace pcl_spiral
