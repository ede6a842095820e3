// SPDX-License-Identifier: BSD-3-Clause
#include "above_ceiling.h"

#include "tool_body.h"

#include <algorithm>

namespace pcl_spiral {

AboveCeiling::AboveCeiling(const CutterProfile& profile, const LocationOptions& options) : options_(options)
{
  if (!std::isfinite(options.ceiling))
    return;
  constexpr double without_end = 1e6; // mm
  cutter_segments_ = cutterCones(profile).size();
  body_ = cutterAndShank(profile, options.holder, options.tool_length);
  double widest = profile.radius();
  for (const ToolSegment& s : options.holder)
    widest = std::max({widest, s.lower_radius, s.upper_radius});
  beyond_ = HolderProfile({ToolSegment::cylinder(widest, without_end, "")}, options.tool_length, widest, 0.0);
}

} // namespace pcl_spiral
