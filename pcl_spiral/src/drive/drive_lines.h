// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Level lines of a scan made whole. Private.
 */
#pragma once

#include "graph/level_lines.h"
#include <pcl_spiral/core/polyline.h>

#include <vector>

namespace pcl_spiral {

/** Gaps up to this are crossed, in spacings of the scan: half as wide as empty circles that still count as
 * surface. */
constexpr double widest_gap = 3.0;

/** A line on the surface. */
struct DriveLine {
  Polyline points;
  bool closed = false;
};

/** A triangulation with small flaws closed: its loops no longer than eight spacings, but for the outline of
 * each part.
 */
Triangulation withoutFlaws(const SurfaceGraph& graph);

std::vector<DriveLine> driveLines(const std::vector<LevelLine>& lines, const SurfaceGraph& graph);

/** The lines, each led on over a gap of no more than \p most to the one that begins there, nearest pairs
 * first; closed where it leads back to its own begin. Directions are kept. */
std::vector<DriveLine> joined(std::vector<DriveLine> lines, double most);

/** Take out lines shorter than \p spacing, and those shorter than four whose middle is within two of a longer
 * line: second sheets of a triangulation in noise. Returns how many. */
std::size_t dropShort(std::vector<DriveLine>& lines, double spacing);

} // namespace pcl_spiral
