// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What looks wrong about a scan but may be intended.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/spiral/spiral_settings.h>

namespace pcl_spiral {

/** Warnings, with values and remedies: a size that no part has (under 1 mm or over 100 m across), turns farther apart than
 *  half the part, points farther apart than the cutter is wide, a scallop below the scan's noise. */
Diagnostics scanWarnings(const SurfaceGraph& graph, const SpiralSettings& settings);

/** Whether points \p spacing apart show the hollows that a ball of \p tool_radius fits into: not if it passes between them. */
inline bool
showsHollows(double spacing, double tool_radius)
{
  return spacing <= 2.0 * tool_radius;
}

} // namespace pcl_spiral
