// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The least length of a path over a surface with radial lines.
 */
#pragma once

#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/spiral/spiral_settings.h>

namespace pcl_spiral {

/** Lower bound in mm for a path at the scallop height of \p settings, as StepOverDistance::least_length: the integral of dA divided by
 *  the largest step-over over the areas between neighbouring \p lines, plus half the boundary length. */
double leastLength(const RadialLineSet& lines, const SpiralSettings& settings);

} // namespace pcl_spiral
