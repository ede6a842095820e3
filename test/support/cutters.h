// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Random cutters of every kind.
 */
#pragma once

#include "support/sampling.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/impl/swept_error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

/** One of the six kinds, all with the same probability, with random measures in their ranges; radii from 0.5 to 20 mm. */
inline CutterShape
randomCutter(Random& random)
{
  const double radius = random.uniform(0.5, 20.0), angle = random.uniform(0.5, 60.0);
  const double longest = radius / std::sin(angle * M_PI / 180.0);
  const double flank = random.uniform(0.05, 0.95) * longest;
  const double share = random.uniform(0.02, 0.98);
  switch (random.below(6)) {
  case 0:
    return CutterShape::ball(radius, random.uniform(0.0, 30.0));
  case 1:
    return CutterShape::flatEnd(radius, random.uniform(0.1, 30.0));
  case 2:
    return CutterShape::bullNose(radius, share * radius, random.uniform(0.1, 30.0));
  case 3:
    return CutterShape::taper(radius, flank, angle);
  case 4:
    return CutterShape::taperedBall(radius, flank, angle);
  default: {
    const double largest = CutterShape::taperedBall(radius, flank, angle).corner_radius;
    return CutterShape::taperedBullNose(radius, share * largest, flank, angle);
  }
  }
}

/** Depth of \p p in the cutter with an endless cylinder as shank; negative outside: the least over all planes that
 *  bound the convex body. */
inline double
depthOf(const Eigen::Vector3d& p, const CutterProfile& c, const CutterPlace& place)
{
  const double z = (p - place.tip).dot(place.axis), l = (p - place.tip - z * place.axis).norm();
  const double a = c.flankAngle(), r = c.cornerRadius();
  const double u = l - c.flatRadius(), v = z - r; // from the middle of the corner
  double depth = std::min({z, c.radius() - l, r - (u * std::cos(a) - v * std::sin(a))});
  if (u > 0.0 && v < 0.0 && -v >= u * std::tan(a))
    depth = std::min(depth, r - std::hypot(u, v));
  return depth;
}

/** The place at share \p t of a move; tip and axis change linearly. */
inline CutterPlace
onTheWay(const CutterPlace& a, const CutterPlace& b, double t)
{
  const double turn = std::acos(std::min(1.0, a.axis.dot(b.axis)));
  if (turn < 1e-12)
    return {a.tip + t * (b.tip - a.tip), a.axis};
  const Eigen::Vector3d pivot = a.axis.cross(b.axis).normalized();
  return {a.tip + t * (b.tip - a.tip), Eigen::AngleAxisd(t * turn, pivot) * a.axis};
}

} // namespace pcl_spiral::test
