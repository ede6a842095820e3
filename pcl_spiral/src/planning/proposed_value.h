// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Values that a refusal proposes, given to an input. Private to planning.
 */
#pragma once

#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace pcl_spiral {

/** Gives \p input the value that is \p proposed by a refusal at \p place; what it was given, as it is shown: numbers have three digits and
 *  do not exceed what is proposed, and places and boxes that are kept out are in whole micrometres. By a number proposed for addKeepOut, a
 *  box about the keep-out nearest to \p place grows. Nothing if the input has this value, or no such setting. */
std::optional<Given> takeProposed(const Proposed& proposed, const Eigen::Vector3d& place, PlanInput& input);

/** Whether the surface of the scan is the same for all values of the \p setter. */
bool keepsSurface(const std::string& setter);

/** The rectangle about \p box in x and y, without end along z. */
Prism uprightPrism(const Eigen::AlignedBox3d& box);

/** \p value to three digits, not above it, as it is shown: what is tried is what is named. */
double roundedDown(double value);

/** Gives the variable of \p to the value of \p from, the same setting of another object. */
void copyValue(const Setting& from, const Setting& to);

} // namespace pcl_spiral
