/** \file
 *  Cutters of every kind, at random.
 */
#pragma once

#include "support/sampling.h"

#include <pcl_spiral/core/cutter_profile.h>

#include <cmath>

namespace pcl_spiral::test {

/** One of the six kinds, each as often, its measures anywhere in their ranges; radii from 0.5 to 20 mm. */
inline CutterShape
randomCutter(Random& random)
{
  const double radius = random.uniform(0.5, 20.0), angle = random.uniform(0.5, 60.0);
  const double longest = radius / std::sin(angle * M_PI / 180.0);
  const double flank = random.uniform(0.05, 0.95) * longest;
  const double share = random.uniform(0.02, 0.98);
  switch (random.below(6)) {
  case 0: return CutterShape::ball(radius, random.uniform(0.0, 30.0));
  case 1: return CutterShape::flatEnd(radius, random.uniform(0.1, 30.0));
  case 2: return CutterShape::bullNose(radius, share * radius, random.uniform(0.1, 30.0));
  case 3: return CutterShape::taper(radius, flank, angle);
  case 4: return CutterShape::taperedBall(radius, flank, angle);
  default: {
    const double largest = CutterShape::taperedBall(radius, flank, angle).corner_radius;
    return CutterShape::taperedBullNose(radius, share * largest, flank, angle);
  }
  }
}

} // namespace pcl_spiral::test
