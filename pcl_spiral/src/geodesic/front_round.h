// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One round of a front.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** All points of a front look in parallel for ways to their neighbours; then the ways are taken, in the order of the points. So the
 *  result does not depend on the threads. */
template <typename Way>
class FrontRound {
public:
  /** Call \p visit(point, ways) for each point of \p front, which appends ways, then \p take(way) for each way. */
  template <typename Visit, typename Take>
  void run(const std::vector<std::uint32_t>& front, Visit visit, Take take)
  {
    constexpr std::size_t piece = 64; // points that one thread takes at a time
    const auto pieces = static_cast<std::int64_t>((front.size() + piece - 1) / piece);
    if (ways_.size() < static_cast<std::size_t>(pieces))
      ways_.resize(pieces);
#pragma omp parallel for schedule(dynamic) if (pieces > 2)
    for (std::int64_t p = 0; p < pieces; ++p) {
      ways_[p].clear();
      for (std::size_t i = p * piece; i < std::min(front.size(), (p + 1) * piece); ++i)
        visit(front[i], ways_[p]);
    }
    for (std::int64_t p = 0; p < pieces; ++p)
      for (const Way& way : ways_[p])
        take(way);
  }

private:
  std::vector<std::vector<Way>> ways_; ///< found by each piece of the front
};

} // namespace pcl_spiral
