// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From which depth on a gouge is shown.
 */
#pragma once

#include <pcl_spiral/core/impl/tolerances.h>

#include <algorithm>

namespace pcl_spiral {

/** Least depth of a gouge in pictures and scenes: what the path may be off, or the noise of the surface if that is more. Lengths in mm. */
inline double
leastGouge(double chord_error, double fit_noise)
{
  return std::max(chord_error, fit_deviations * fit_noise);
}

} // namespace pcl_spiral
