// SPDX-License-Identifier: BSD-3-Clause
#include "control_move.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** The largest rate along \p way with which no axis exceeds its limit. */
double
alongWay(const AxisValues& way, double length, const AxisValues& limits)
{
  double longest = 0.0;
  for (int i = 0; i < way.size(); ++i)
    longest = std::max(longest, std::abs(way[i]) / limits[i]);
  return longest > 0.0 ? length / longest : std::numeric_limits<double>::infinity();
}

} // namespace

ControlMove
controlMove(const AxisValues& way, double length, double speed, const AxisDynamics& axes)
{
  ControlMove move;
  move.way = way;
  move.length = length;
  move.speed = std::min(speed, alongWay(way, length, axes.velocity));
  move.acceleration = alongWay(way, length, axes.acceleration);
  move.jerk = alongWay(way, length, axes.jerk);
  return move;
}

} // namespace pcl_spiral
