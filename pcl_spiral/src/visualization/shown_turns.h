// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Chooses the turns of a spiral that a picture can show separately.
 */
#pragma once

#include "box_axes.h"
#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <algorithm>
#include <string>

namespace pcl_spiral {

/** Every n-th turn, counted back from the last one, and the first. */
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

/** Every turn if turns appear apart; otherwise every n-th, so that in the view nine tenths of the turns that
 * face the viewer are at least \p least_pixels apart. At least six turns are shown if there are six, so that a part
 * seen on edge keeps some. */
ShownTurns chooseTurns(const pcl::PointCloud<ToolpathPoint>& path, const ParallelView& view, double least_pixels);

} // namespace pcl_spiral
