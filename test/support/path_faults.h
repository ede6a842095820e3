// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What no path may do: cross itself, or jump. Lengths in mm.
 */
#pragma once

#include "support/checked_path.h"
#include "support/surfaces.h"

#include <vector>

namespace pcl_spiral::test {

/** Crossings of two moves that cut, strict: in the tangent plane of the first each passes the other's line, by more than
 *  single precision rounds. Value: how far, the least of the four. The deepest first. */
std::vector<Place> strictCrossings(const AnalyticSurface& surface, const CheckedPath& path, int threads = 0);

/** Moves that cut and are longer than \p longest, in order; value: the length. */
std::vector<Place> jumps(const CheckedPath& path, double longest);

} // namespace pcl_spiral::test
