// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which turns of a spiral a picture can show apart.
 */
#pragma once

#include "box_axes.h"
#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <algorithm>
#include <string>

namespace pcl_spiral {

/** Every so manyth turn, counted back from the last one, and the first. */
struct ShownTurns {
  int every = 1;
  int turns = 1; ///< of the whole path

  /** Whether the part of the path at this turn count is shown. */
  bool shows(double turn) const
  {
    const int k = std::min(static_cast<int>(turn), turns - 1);
    return k == 0 || ((turns - 1 - k) % every == 0 && k >= every);
  }
  /** "every turn shown", "every 8th turn shown". */
  std::string caption() const;
};

/** Every turn where turns appear apart; else every so manyth, so that in the view nine tenths of what faces
 * the viewer stands \p least_pixels apart or more. At least six turns are shown where there are six: a part
 * seen on edge keeps some. */
ShownTurns chooseTurns(const pcl::PointCloud<ToolpathPoint>& path, const ParallelView& view, double least_pixels);

} // namespace pcl_spiral
