// SPDX-License-Identifier: BSD-3-Clause
#include "noise_warning.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/tolerances.h>

namespace pcl_spiral {

std::optional<Diagnostic>
noiseWarning(const MlsSurface& surface, const char* what, double asked)
{
  if (!(asked > 0.0) || asked >= surface.noise())
    return std::nullopt;
  const bool hidden = asked < fit_deviations * surface.fitNoise();
  return Diagnostic("the ", what, " asked for, ", asked, " {mm}, {is below the noise of the scan}, ", surface.noise(),
                    " {mm} ({standard deviation of a point}); the surface fitted to ", surface.neighbours(),
                    " points at a time is known to ", surface.fitNoise(),
                    hidden ? " {mm}, and cannot show lengths below three times that: {this scan cannot show whether it was kept}"
                           : " {mm}");
}

} // namespace pcl_spiral
