// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Values that a refusal tells for what it names. Private to planning.
 */
#pragma once

#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/core/setting.h>

#include <Eigen/Geometry>

#include <initializer_list>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The last number of \p said that stands behind one of \p words in its id (Diagnostic::id); 0 if there is none. */
double numberBehind(const Diagnostic& said, std::initializer_list<std::string> words);

/** The places of \p said that stand behind \p words in its id. */
std::vector<Eigen::Vector3d> placesBehind(const Diagnostic& said, const std::string& words);

/** The boxes that \p said gives as "from {place} to {place}". */
std::vector<Eigen::AlignedBox3d> extentsOf(const Diagnostic& said);

/** The rectangle about \p box in x and y, without end along z. */
Prism uprightPrism(const Eigen::AlignedBox3d& box);

/** \p value to three digits, not above it, as it is shown: what is tried is what is named. */
double roundedDown(double value);

/** Gives the variable of \p to the value of \p from, the same setting of another object. */
void copyValue(const Setting& from, const Setting& to);

} // namespace pcl_spiral
