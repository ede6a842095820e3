// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places where loops of one level nearly touch. Private to spiral.
 */
#pragma once

#include "raw_loops.h"
#include "spiral/field/finger_axes.h"

#include <vector>

namespace pcl_spiral {

/** Short axes in the necks of \p loops, and between loops that nearly meet, where the width from inside to inside is below \p width
 *  step-overs. Smoothing would make such lines cross. */
std::vector<FingerAxis> tightNecks(const std::vector<RawLoop>& loops, double width);

} // namespace pcl_spiral
