// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_text.h"

#include <pcl_spiral/core/diagnostic.h>

namespace pcl_spiral {

std::string
cutterText(const CutterShape& c)
{
  if (c.corner_radius == c.radius && c.flank_length == 0.0 && c.flank_angle == 0.0)
    return Diagnostic("radius ", c.radius, " mm, a ball").text();
  return Diagnostic("radius ", c.radius, " mm, corner ", c.corner_radius, " mm").text() +
         (c.flank_length > 0.0 || c.flank_angle > 0.0
              ? Diagnostic(", flank ", c.flank_length, " mm long, ", c.flank_angle, " degrees to the axis").text()
              : std::string());
}

} // namespace pcl_spiral
