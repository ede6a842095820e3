// SPDX-License-Identifier: BSD-3-Clause
#include "raised_field.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double blend = 0.25;     // of smax
constexpr double near_zero = 1e-4; // step-overs: far below the 0.002 within which points of a loop are left out
constexpr int most_steps = 8;      // regula falsi is that near after three or four

/** max(a, b) with a rounded corner. */
double
smoothMax(double a, double b)
{
  const double d = std::max(blend - std::abs(a - b), 0.0);
  return std::max(a, b) + d * d / (4.0 * blend);
}

} // namespace

RaisedField::RaisedField(int level, const std::vector<FingerAxis>& axes) : level_(level)
{
  for (const FingerAxis& axis : axes)
    lines_.add(axis.points, false);
  lines_.build();
}

double
RaisedField::mostRaised()
{
  return finger_radius + blend; // beyond it, D - level is the larger in smax
}

double
RaisedField::at(const FieldPlace& place, std::size_t& last) const
{
  const double over = place.distance - level_, within = std::min(reach, mostRaised() - over);
  const NearestSegment near = lines_.nearestFrom(last, place.point, place.metric, within);
  if (near.segment == NearestSegment::none)
    return over;
  last = near.segment;
  return smoothMax(over, finger_radius - near.distance);
}

/** Regula falsi; an end that stays counts half from then on (Dowell, Jarratt 1971, "Illinois"). */
double
RaisedField::zero(const FieldPlace& below, const FieldPlace& above, double f_below, double f_above) const
{
  double low = 0.0, high = 1.0, share = -f_below / (f_above - f_below);
  std::size_t last = NearestSegment::none;
  int side = 0; // the end that was replaced before
  for (int i = 0; i < most_steps; ++i) {
    const double f = at(between(below, above, share), last);
    if (std::abs(f) < near_zero)
      break;
    if (f < 0.0) {
      low = share;
      f_below = f;
      f_above *= side < 0 ? 0.5 : 1.0;
      side = -1;
    }
    else {
      high = share;
      f_above = f;
      f_below *= side > 0 ? 0.5 : 1.0;
      side = 1;
    }
    share = low - (high - low) * f_below / (f_above - f_below);
  }
  return share;
}

} // namespace pcl_spiral
