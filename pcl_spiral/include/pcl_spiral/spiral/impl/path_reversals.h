// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places where a path turns back on itself.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Places, and for each place the turns completed up to it. */
struct TurnedPath {
  const Polyline& places;
  const std::vector<float>& turns;
  const std::vector<std::size_t>& passes; ///< as in SpiralPath
};

/** 1 for each point of \p path that is a whole turn away from both ends of its pass. The first and the last turn run about the centre or
 *  along a boundary: corners of the outline are legitimate there, and the turns next to them meet them. */
std::vector<std::uint8_t> betweenEnds(const TurnedPath& path);

/** Turns of more than 150 degrees from one move to the next, at points that \p counted marks. The turn along the rim shows which of them
 *  are at corners of the outline that are as sharp, to 10 degrees. */
PathReversals findReversals(const TurnedPath& path, const std::vector<std::uint8_t>& counted);

/** The same between the ends of a \p curve that is not yet on the surface. */
PathReversals curveReversals(const std::vector<SpiralPoint>& curve);

/** Turns of the centre of the ball of radius \p tool_radius, mm, by more than 150 degrees from one move to the next, at points of \p path
 *  whose feet do not turn back: where the ball is lifted, and where the surface is nearly as hollow as the ball. */
PathReversals ballReversals(const SpiralPath& path, double tool_radius);

/** Ok, or an error with the remedy. Reversals at corners of the outline are allowed, and all those of SpiralMethod::ConstantScallop, whose
 *  fingers turn back. */
Status checkReversals(const PathReversals& reversals, const SpiralSettings& settings);

/** The remedy for turns that cross or turn back: the other method, without the settings that it does not take. */
Diagnostic constantScallopRemedy(const SpiralSettings& settings);

/** Place, angle and number of \p reversals, as the first part of a message. */
Diagnostic reversalText(const PathReversals& reversals);

} // namespace pcl_spiral
