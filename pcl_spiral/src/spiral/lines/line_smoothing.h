// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines smoothed to remove the zigzag of their mesh.
 */
#pragma once

#include <pcl_spiral/spiral/scallop_loop.h>

#include <vector>

namespace pcl_spiral {

/** How a line is drawn again, one entry a point; step-overs. */
struct LineGrain {
  std::vector<double> steps;  ///< distance of the new points
  std::vector<double> widths; ///< half the length over which a parabola is fitted
};

/** \p loop drawn again: each new point is the middle of a parabola in arc length, fitted to the old points about it by least
 *  squares with weights (1 - |t|^3)^3. Circles keep their radius to the fourth order of width / radius. */
ScallopLoop smoothed(const ScallopLoop& loop, const LineGrain& grain);

/** Points of \p loop to keep, ascending, with the first one. The others lie within \p tolerance of the straight lines between them,
 *  which are no longer than \p longest; both in step-overs. */
std::vector<std::size_t> pointsKept(const ScallopLoop& loop, double tolerance, double longest);

} // namespace pcl_spiral
