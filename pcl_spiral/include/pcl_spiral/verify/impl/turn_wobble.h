// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Waviness of a path from turn to turn.
 */
#pragma once

#include <pcl_spiral/verify/impl/cutter_path.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Unevenness of neighbouring turns, mm. At a contact of turn t with the deviation d (along the surface normal,
 *  positive out of the material) it is d(t) - (d(t - 1) + d(t + 1)) / 2: half the second difference across the
 *  feed. The deviations of the neighbouring turns are taken at the same share of a turn, between their two nearest
 *  contacts. An error that is the same on all turns, or changes evenly across them, gives no wobble. Independent
 *  errors of standard deviation s give a wobble of 1.22 s rms. If the deviation is measured from a scan, path and
 *  reference may share the same noise, and that part does not show: judge by a second scan to see it. */
struct TurnWobble {
  std::size_t measured = 0; ///< contacts with a measured deviation on their turn and on both neighbouring turns
  double rms = 0.0;
  PlacedValue max; ///< the largest in absolute value, with its sign
};

/** \p deviation: of each contact, NaN where it is not measured. Nothing is measured on a path without
 *  ascending turns, or on a path whose turn stays the same along each pass, such as counted rows. */
TurnWobble turnWobble(const CutterPath& path, const std::vector<float>& deviation);

} // namespace pcl_spiral
