// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_text.h"

#include <pcl_spiral/common/impl/message.h>

namespace pcl_spiral {

std::string
cutterText(const CutterShape& c)
{
  if (c.corner_radius == c.radius && c.flank_length == 0.0 && c.flank_angle == 0.0)
    return textOf("radius ", c.radius, " mm, a ball");
  return textOf("radius ", c.radius, " mm, corner ", c.corner_radius, " mm") +
         (c.flank_length > 0.0 || c.flank_angle > 0.0
              ? textOf(", flank ", c.flank_length, " mm long, ", c.flank_angle, " degrees to the axis")
              : std::string());
}

} // namespace pcl_spiral
