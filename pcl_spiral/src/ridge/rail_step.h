// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far the stations of a rail must move.
 */
#pragma once

#include "section_shift.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** The shift of each section. A section that was not found gets the shift of its neighbours, so that the rail keeps its length. Returns
 *  the section at which a third of all in a row were not found, if any. */
std::optional<std::size_t> allShifts(const std::vector<SectionShift>& shifts, bool closed, std::vector<SectionShift>& all);

/** Weights of the three places before an end of a rail that extrapolate the parabola through them to the end. The nearest first. */
constexpr std::array<double, 3> carry_on{3.0, -3.0, 1.0};

/** Steps x of the stations, along chord and up, after which the generator lies on the sections without a shift.
 *
 *  Where a rail with a slope turns sideways, its frame rolls: by q = (m1.N)/(m3.N) times the angle, \see ridgeTurn. A flat generator that
 *  is rolled by r fits its section best with a shift of some radii of its curvature times r, given by SectionShift::roll. So the rail
 *  does not move by its shifts s only, because short waves of it would grow. The steps solve x + roll q dx_b/du = s by least squares,
 *  for stations
 *  \p length apart. The ends of an open rail are half extrapolated: a turn of an end looks like a step of it, so its own section does
 *  not show where it is. */
Polyline railSteps(const std::vector<SectionShift>& shifts, const std::vector<RidgeFrame>& frames, const Eigen::Vector3d& reference,
                   double length, bool closed);

} // namespace pcl_spiral
