// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds the loops beside a place.
 */
#pragma once

#include "spiral/lines/segment_set.h"

#include <pcl_spiral/spiral/scallop_loop.h>

#include <vector>

namespace pcl_spiral {

/** A place on a loop. */
struct LoopPlace {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t loop = none;
  double u = 0.0;        ///< along it, step-overs
  double distance = 0.0; ///< from the given point, step-overs
};

/** Searches the loops of each level. */
class LoopFinder {
public:
  explicit LoopFinder(const std::vector<ScallopLoop>& loops);

  /** The nearest place on the loops of \p level within \p within step-overs; the loop \p but does not count. */
  LoopPlace nearest(int level, const Eigen::Vector3d& p, const StepOverMetric& metric, double within,
                    std::size_t but = LoopPlace::none) const;
  int levels() const { return static_cast<int>(sets_.size()); }

private:
  const std::vector<ScallopLoop>& loops_;
  std::vector<SegmentSet> sets_;
};

} // namespace pcl_spiral
