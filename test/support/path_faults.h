// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Faults that no path may have: crossings with itself, and jumps. Lengths in mm.
 */
#pragma once

#include "support/checked_path.h"
#include "support/surfaces.h"

#include <vector>

namespace pcl_spiral::test {

/** Crossings of two cutting moves, strict: in the tangent plane of the first, each goes beyond the line of the other by more
 *  than the rounding of single precision. Value: how far, the least of the four. The deepest first. */
std::vector<Place> strictCrossings(const AnalyticSurface& surface, const CheckedPath& path, int threads = 0);

/** Cutting moves longer than \p longest, in order; value: the length. */
std::vector<Place> jumps(const CheckedPath& path, double longest);

} // namespace pcl_spiral::test
