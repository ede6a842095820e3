// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Joins pieces of level lines on a scan. Private.
 */
#pragma once

#include "graph/level_lines.h"
#include <pcl_spiral/core/polyline.h>

#include <vector>

namespace pcl_spiral {

/** Lines cross gaps up to this, in spacings of the scan: half the width of empty circles that still count as
 *  surface. */
constexpr double widest_gap = 3.0;

/** A line on the surface. */
struct DriveLine {
  Polyline points;
  bool closed = false;
};

/** A triangulation with small gaps closed: those with loops of up to eight spacings, without the outline of
 *  each part.
 */
Triangulation withoutFlaws(const SurfaceGraph& graph);

std::vector<DriveLine> driveLines(const std::vector<LevelLine>& lines, const SurfaceGraph& graph);

/** The lines, each joined over a gap of at most \p most to the line that begins there, nearest pairs
 *  first; closed if it leads back to its own begin. Directions are kept. */
std::vector<DriveLine> joined(std::vector<DriveLine> lines, double most);

/** Remove lines shorter than \p spacing, and lines shorter than four spacings with their middle within two of a
 *  longer line: they come from second layers of a triangulation in noise. Returns how many. */
std::size_t dropShort(std::vector<DriveLine>& lines, double spacing);

} // namespace pcl_spiral
