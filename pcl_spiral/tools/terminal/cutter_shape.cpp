// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_shape.h"

#include "terminal.h"

#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

using namespace pcl_spiral;

void
completeCutter(bool corner_given, CutterShape& cutter)
{
  const double angle = cutter.flank_angle * degree;
  if (!corner_given && angle == 0.0)
    cutter.corner_radius = cutter.radius;
  else if (!corner_given)
    cutter.corner_radius = (cutter.radius - cutter.flank_length * std::sin(angle)) / std::cos(angle);
  if (const Diagnostic fault = faultOf(cutter); !fault.empty())
    throw UsageError(Diagnostic("the cutter of --tool-radius, --corner-radius, --flank-length and --flank-angle: ", fault));
}
