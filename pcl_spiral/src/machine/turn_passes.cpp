// SPDX-License-Identifier: BSD-3-Clause
#include "turn_passes.h"

#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double turn_rounding = 1e-9;

bool
isWithin(double angle, const AxisRange& range)
{
  return angle >= range.lower - turn_rounding && angle <= range.upper + turn_rounding;
}

/** The last location that can be reached from \p first with \p shift. */
std::size_t
reach(const MachineLocations& path, std::size_t first, double shift, const AxisRange& range)
{
  std::size_t last = first;
  while (last + 1 < path.size() && isWithin(path[last + 1].angles.first + shift, range))
    ++last;
  return last;
}

/** Shifts by whole turns that bring \p angle into the range, the one nearest to home first. */
std::vector<double>
shifts(double angle, const RotaryAxis& axis)
{
  std::vector<double> found;
  const double nearest = full_turn * std::round((axis.home - angle) / full_turn);
  for (int k = 0; k <= 1000; ++k) {
    bool any = false;
    for (double shift : {nearest + k * full_turn, nearest - k * full_turn})
      if (isWithin(angle + shift, axis.range) && (k > 0 || !any)) {
        found.push_back(shift);
        any = true;
      }
    if (!any && k > 1)
      break;
  }
  return found;
}

} // namespace

std::vector<TurnPass>
turnPasses(const MachineLocations& path, const RotaryAxis& axis, std::size_t& failed)
{
  if (!axis.range.finite())
    return {{0, path.size() - 1, 0.0}};
  std::vector<TurnPass> passes;
  std::size_t at = 0;
  do {
    TurnPass best{at, at, 0.0};
    bool found = false;
    for (double shift : shifts(path[at].angles.first, axis)) {
      const std::size_t last = reach(path, at, shift, axis.range);
      if (!found || last > best.last)
        best = {at, last, shift};
      found = true;
    }
    if (!found || best.last == at) {
      failed = at;
      return {};
    }
    passes.push_back(best);
    at = best.last;
  } while (at + 1 < path.size());
  return passes;
}

} // namespace pcl_spiral
