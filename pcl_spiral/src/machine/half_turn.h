/** \file
 *  Angles that stand for the same direction.
 */
#pragma once

#include <cmath>

namespace pcl_spiral {

/** The angle nearest to \p near among \p angle and whole turns more or less. */
inline double
nearestTurn(double angle, double near)
{
  constexpr double turn = 2.0 * 3.14159265358979323846;
  return angle - turn * std::round((angle - near) / turn);
}

} // namespace pcl_spiral
