// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A field that is raised about the axes of fingers.
 */
#pragma once

#include "spiral/field/finger_axes.h"

namespace pcl_spiral {

/** A place on a triangle of a field. */
struct FieldPlace {
  Eigen::Vector3d point;
  StepOverMetric metric;
  double distance; ///< D, linear over the triangle
};

inline FieldPlace
between(const FieldPlace& a, const FieldPlace& b, double share)
{
  return {(1.0 - share) * a.point + share * b.point, between(a.metric, b.metric, share), (1.0 - share) * a.distance + share * b.distance};
}

/** F = smax(D - level, finger_radius - distance from the nearest axis): its zeros are the loops of the level with fingers about the axes.
 *  smax is max with a rounded corner. D is linear over a triangle, F is not: a finger may be narrower than a triangle is long. */
class RaisedField {
public:
  RaisedField(int level, const std::vector<FingerAxis>& axes);

  /** Beyond this distance from an axis F is D - level, step-overs. */
  static constexpr double reach = 1.2;
  /** And where D is this far above the level. */
  static double mostRaised();

  /** F at \p place. \p last: the segment of an axis that was nearest to the place before, where the search begins; updated. */
  double at(const FieldPlace& place, std::size_t& last) const;
  /** Share of the way from \p below to \p above at which F is zero; \p f_below < 0 and \p f_above >= 0: F at these. */
  double zero(const FieldPlace& below, const FieldPlace& above, double f_below, double f_above) const;

private:
  int level_;
  SegmentSet lines_;
};

} // namespace pcl_spiral
