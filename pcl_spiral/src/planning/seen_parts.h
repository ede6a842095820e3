// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The separate parts of a scan before it is closed by the ball. Private to planning.
 */
#pragma once

#include <pcl_spiral/planning/impl/spiral_planning.h>

namespace pcl_spiral {

/** The separate parts of a scan as it was seen: closed by the ball, those beside each other are one surface. */
struct SeenParts {
  Diagnostic joined;                               ///< which parts the closed surface may join; empty: none, or one was chosen
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr chosen; ///< the part that was chosen; null: none was, or there is only one
};

/** Finds the parts of the scan of \p input, and the one that was chosen (PartChoice::part_at, SurfaceSettings::largest_part, indices). */
Status findSeenParts(const PlanInput& input, SeenParts& seen);

} // namespace pcl_spiral
