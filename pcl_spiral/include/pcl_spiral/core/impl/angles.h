// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Angles in radians and degrees.
 */
#pragma once

namespace pcl_spiral {

constexpr double pi = 3.14159265358979323846;
constexpr double quarter_turn = 0.5 * pi; ///< radians
constexpr double full_turn = 2.0 * pi;    ///< radians
constexpr double degree = pi / 180.0;     ///< radians
constexpr double in_degrees = 180.0 / pi; ///< radians times this

} // namespace pcl_spiral
