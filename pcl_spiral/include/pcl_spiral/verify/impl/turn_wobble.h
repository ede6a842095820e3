/** \file
 *  How wavy a path is from turn to turn.
 */
#pragma once

#include <pcl_spiral/verify/impl/cutter_path.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Unevenness of neighbouring turns, mm. At a contact of turn t with the deviation d (along the surface normal, positive
 *  out of the material) it is d(t) - (d(t - 1) + d(t + 1)) / 2: half the second difference across the feed, the
 *  deviations of the turns beside taken at the same share of a turn, between their two nearest contacts. An error that
 *  the turns share, or that changes evenly across them, makes no wobble; independent errors of standard deviation s make
 *  one of 1.22 s rms. Where the deviation is measured from a scan, what the path and the reference have both from the same
 *  noise does not show: judge by a second scan to see it. */
struct TurnWobble {
  std::size_t measured = 0; ///< contacts with a measured deviation on their turn and on both beside it
  double rms = 0.0;
  PlacedValue max; ///< the largest in amount, with its sign
};

/** \p deviation: of each contact, NaN where it is not measured. Nothing is measured on a path without ascending turns, nor on one whose
 *  turns stand still along its passes, as rows that are counted have them. */
TurnWobble
turnWobble(const CutterPath& path, const std::vector<float>& deviation);

} // namespace pcl_spiral
