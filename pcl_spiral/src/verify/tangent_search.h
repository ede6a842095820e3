// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The largest value of a concave function, by its tangents. Private to verify.
 */
#pragma once

#include <algorithm>

namespace pcl_spiral {

/** A value, its slope, and its slope in another direction. */
struct Tangent {
  double value, slope, other;
};

/** Where the tangents of a concave function at \p a and \p b meet: \p at is the place, \p bound the height. */
struct TangentMeeting {
  double at, bound;
};

inline TangentMeeting
meetingOf(double a, const Tangent& at_a, double b, const Tangent& at_b)
{
  const double at = std::clamp((at_b.value - at_a.value + at_a.slope * a - at_b.slope * b) / (at_a.slope - at_b.slope), a, b);
  return {at, at_a.value + at_a.slope * (at - a)};
}

/** The largest value of the concave function \p at, which gives a Tangent, in [low, high] to \p settled; a bound of it if that is not
 *  above \p least. The other slope is that of the largest value: between those of the two sides where the function has an edge. Kelley
 *  1960, The cutting-plane method for solving convex programs. */
template <typename Function>
Tangent
largestOf(const Function& at, double low, double high, double least, double settled)
{
  constexpr int rounds = 60;
  Tangent first = at(low);
  if (first.slope <= 0.0)
    return first;
  if (const double bound = first.value + first.slope * (high - low); bound <= least)
    return {bound, 0.0, 0.0};
  Tangent last = at(high);
  if (last.slope >= 0.0)
    return last;
  for (int i = 0; i < rounds; ++i) {
    const TangentMeeting meeting = meetingOf(low, first, high, last);
    if (meeting.bound <= least)
      return {meeting.bound, 0.0, 0.0};
    if (meeting.bound - std::max(first.value, last.value) < settled)
      break;
    // On a smooth function the slopes lead faster to the top, on an edge the tangents.
    const double place = i % 2 == 0 ? low + (high - low) * first.slope / (first.slope - last.slope) : meeting.at;
    const Tangent middle = at(place);
    if (middle.slope == 0.0)
      return middle;
    (middle.slope > 0.0 ? low : high) = place;
    (middle.slope > 0.0 ? first : last) = middle;
  }
  const double share = first.slope / (first.slope - last.slope);
  return {std::max(first.value, last.value), 0.0, (1.0 - share) * first.other + share * last.other};
}

} // namespace pcl_spiral
