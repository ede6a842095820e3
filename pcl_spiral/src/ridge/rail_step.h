// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the stations of a rail have to move by.
 */
#pragma once

#include "section_shift.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** The shift of each section; of one that was not found that of its neighbours, so that the rail keeps its length. The section where a
 *  third of all in a row were not found, if any. */
std::optional<std::size_t> allShifts(const std::vector<SectionShift>& shifts, bool closed, std::vector<SectionShift>& all);

/** Shares of the three places before an end of a rail by which the parabola through them goes on to the end. The nearest first. */
constexpr std::array<double, 3> carry_on{3.0, -3.0, 1.0};

/** Steps x of the stations, along chord and up, after which the generator lies on the sections without a shift.
 *
 *  Where a rail with a slope turns sideways, its frame rolls: by q = (m1.N)/(m3.N) times the angle, \see ridgeTurn. A flat generator that
 *  is rolled by r lies best on its section when shifted by some radii of its curvature times r, which SectionShift::roll tells. So the
 *  rail does not move by its shifts s alone, which would make short waves of it grow: x + roll q dx_b/du = s, by least squares, for
 *  stations
 *  \p length apart. The ends of an open rail are half carried on: a turn of an end looks much like a step of it, so that its own section
 *  alone does not tell where it is. */
Polyline railSteps(const std::vector<SectionShift>& shifts, const std::vector<RidgeFrame>& frames, const Eigen::Vector3d& reference,
                   double length, bool closed);

} // namespace pcl_spiral
