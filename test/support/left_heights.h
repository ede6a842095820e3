// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The heights that a swept ball leaves on an exact surface. Lengths in mm.
 */
#pragma once

#include "support/checked_path.h"
#include "support/judged_area.h"
#include "support/stock.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral::test {

/** The ball and its settings. */
struct SweptBall {
  double radius = 0.0, h = 0.0;
  double longest_move = 0.0; ///< on longer moves the ball is lifted
  int threads = 0;           ///< 0: all
};

/** Height over each of \p count points spread evenly by area over the whole surface, from the capsules
 * that the ball fills along the straight moves between its centres. Rays reach 20 h: more is uncut. */
std::vector<StockSample> heightsLeft(const AnalyticSurface& surface, const CheckedPath& path, const SweptBall& ball, std::size_t count,
                                     std::uint64_t seed);

/** Figures of heights, as multiples of h; so is the value of a place. */
struct HeightReport {
  std::size_t samples = 0;
  Place p99, p999, max;    ///< each with a sample of that height; uncut counts as 20
  double over_share = 0.0; ///< above 1.05
  double uncut_share = 0.0;
  Place uncut; ///< the uncut sample farthest from the rim
  Place gouge; ///< deepest cut below the surface
};

/** Figures of the samples that \p counts selects by position; \p area gives the distance to the rim. */
HeightReport heightFigures(const std::vector<StockSample>& samples, const CheckedPath& path, const JudgedArea& area, double h,
                           const std::function<bool(std::size_t)>& counts);

} // namespace pcl_spiral::test
