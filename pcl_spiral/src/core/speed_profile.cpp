// SPDX-License-Identifier: BSD-3-Clause
#include "speed_profile.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int halvings = 50;

/** Time to change the speed by \p change, above 0. */
double
changeTime(double change, double acceleration, double jerk)
{
  if (!std::isfinite(jerk))
    return change / acceleration;
  return change * jerk >= acceleration * acceleration ? change / acceleration + acceleration / jerk : 2.0 * std::sqrt(change / jerk);
}

/** Way to go from speed \p low to \p high: an S-curve is symmetric about its middle. */
double
changeWay(double low, double high, const MotionElement& element)
{
  return 0.5 * (low + high) * changeTime(high - low, element.acceleration, element.jerk);
}

/** The speed, at most \p most, that \p element reaches from \p from over \p way. */
double
reachedSpeed(double from, double way, double most, const MotionElement& element)
{
  if (most <= from)
    return most;
  if (!std::isfinite(element.jerk))
    return std::min(most, std::sqrt(from * from + 2.0 * element.acceleration * way));
  double low = from, high = std::min(most, std::sqrt(from * from + 2.0 * element.acceleration * way));
  if (changeWay(low, high, element) <= way)
    return high;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (changeWay(from, middle, element) <= way ? low : high) = middle;
  }
  return low;
}

/** The largest speed between the ends of \p element. */
double
peakSpeed(double entry, double exit, const MotionElement& element)
{
  const double square = entry * entry + exit * exit;
  double low = std::max(entry, exit);
  double high = std::clamp(std::sqrt(0.5 * square + element.acceleration * element.length), low, std::max(low, element.speed));
  if (!std::isfinite(element.jerk))
    return high;
  const auto fits = [&](double peak) { return changeWay(entry, peak, element) + changeWay(exit, peak, element) <= element.length; };
  if (fits(high))
    return high;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

ElementTime
timeOf(double entry, double exit, const MotionElement& element)
{
  const double peak = peakSpeed(entry, exit, element);
  ElementTime time;
  time.rise = changeTime(peak - entry, element.acceleration, element.jerk);
  time.fall = changeTime(peak - exit, element.acceleration, element.jerk);
  const double ramps = 0.5 * (entry + peak) * time.rise + 0.5 * (exit + peak) * time.fall;
  time.seconds = time.rise + time.fall + std::max(0.0, element.length - ramps) / peak;
  return time;
}

/** Lowers the exits to what is left where the control assumes a stop \p look_ahead elements behind each. */
void
lowerToLookAhead(const std::vector<MotionElement>& elements, std::size_t look_ahead, std::vector<double>& exits)
{
  double square = 0.0; // of the speed that comes to a stop within the elements ahead
  for (std::size_t i = elements.size(); i-- > 0;) {
    exits[i] = std::min(exits[i], std::sqrt(std::max(0.0, square)));
    square += 2.0 * elements[i].acceleration * elements[i].length;
    if (i + look_ahead < elements.size())
      square -= 2.0 * elements[i + look_ahead].acceleration * elements[i + look_ahead].length;
  }
}

} // namespace

std::vector<ElementTime>
elementTimes(const std::vector<MotionElement>& elements, std::size_t look_ahead)
{
  std::vector<double> exits(elements.size(), 0.0);
  for (std::size_t i = elements.size() - 1; i-- > 0;)
    exits[i] = reachedSpeed(exits[i + 1], elements[i + 1].length, std::min(elements[i].exit, elements[i + 1].speed), elements[i + 1]);
  lowerToLookAhead(elements, look_ahead, exits);
  std::vector<ElementTime> times;
  double entry = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double exit = reachedSpeed(entry, elements[i].length, exits[i], elements[i]);
    times.push_back(timeOf(entry, exit, elements[i]));
    entry = exit;
  }
  return times;
}

} // namespace pcl_spiral
