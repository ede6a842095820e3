// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/cutter_profile.h>

namespace pcl_spiral {

std::optional<double>
stepForScallop(const CutterProfile& profile, double scallop)
{
  if (!(scallop > 0.0))
    return std::nullopt;
  return 2.0 * profile.radiusAt(scallop);
}

} // namespace pcl_spiral
