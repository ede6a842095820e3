// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Angles of the same direction.
 */
#pragma once

#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

namespace pcl_spiral {

/** The angle nearest to \p near among \p angle plus or minus whole turns. */
inline double
nearestTurn(double angle, double near)
{
  return angle - full_turn * std::round((angle - near) / full_turn);
}

} // namespace pcl_spiral
