// SPDX-License-Identifier: BSD-3-Clause
#include "published_step.h"

#include <pcl_spiral/core/step_over.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

double
publishedStep(const std::vector<RadialLine>& lines, double chord_error, double largest_step)
{
  double sharpest = 0.0;
  for (const RadialLine& line : lines)
    for (const SurfaceFoot& foot : line.feet)
      sharpest = std::max({sharpest, std::abs(foot.curvature1), std::abs(foot.curvature2)});
  return stepFromChordError(sharpest, chord_error, largest_step); // (13)-(15)
}

} // namespace pcl_spiral
