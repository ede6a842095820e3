// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks a toolpath against an exact surface and against itself: deviation, normals, gaps, turning, crossings. mm,
 * degrees.
 */
#pragma once

#include "support/checked_path.h"
#include "support/surfaces.h"

#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

struct ToolpathReport {
  double length = 0.0;
  double deviation_rms = 0.0, deviation_p99 = 0.0; ///< of |signed distance of the contact to the surface|
  Place deviation;                                 ///< largest; value keeps its sign
  Place normal_error;                              ///< largest angle of a normal to the exact one
  Place gap;                                       ///< longest move
  Place turning;    ///< largest angle between neighbouring moves, farther than clear from the ends and the outline
  Place beyond_rim; ///< farthest contact past the outline
  Place rim_missed; ///< outline point farthest from the path
  std::size_t crossings = 0;
  Place crossing; ///< deepest; value is how far each move goes beyond the other
};

/** \p clear: turning is not measured within this distance from both ends of the path and from the outline.
 */
ToolpathReport checkPath(const AnalyticSurface& surface, const CheckedPath& path, double clear, int threads = 0);

/** Crossings of the path with itself, in the chart of the surface, deeper than \p tolerance. */
std::vector<Place> crossings(const AnalyticSurface& surface, const CheckedPath& path, double tolerance = 0.01, int threads = 0);

} // namespace pcl_spiral::test
