// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Adds locations until the cutter can go straight from one to the next.
 */
#pragma once

#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** When locations are added; see CutterLocation::setPathTolerance. */
struct BisectionSettings {
  double tolerance = 0.01; ///< mm: no move cuts deeper than this into the surface, or leaves more than this above it
  int most_halvings = 12;  ///< of one move; a move that is beyond the tolerance after these is reported
};

/** Adds locations between those of \p passes, each in travel order, until no move has an error above the tolerance.
 *
 *  The error of a move is what it may cut, see CutterLocationEngine::moveError, or how far the cutter in the middle of the
 *  move stands above the place where it would touch, whichever is more. Where the error is too large, the middle
 *  becomes a location: its axis is the sum of both axes, of unit length, and the cutter comes down along it through
 *  the middle of both tips. Source: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Our
 *  additions: material left is judged too. The bound for clouds assumes the worst between two locations (a sharp edge
 *  on a slope needs them 0.05 mm apart). So moves are halved down to half the tolerance; then added locations are
 *  removed again if the cutter shifts by no more than the other half. Given locations stay. The same for any number
 *  of threads. Fails as CutterLocationEngine::locate does, and on a setting out of range; \p passes are then unchanged. */
Status bisectLocations(const CutterLocationEngine& locator, const BisectionSettings& settings, const ProgressCallback& progress,
                       std::vector<ToolLocations>& passes, BisectionReport& figures);

} // namespace pcl_spiral
