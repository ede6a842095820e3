// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines from node to node, made smooth.
 */
#pragma once

#include "finger_axes.h"

namespace pcl_spiral {

/** The line over \p nodes, its points 0.05 step-overs apart, smoothed \p rounds times with its ends held. */
FingerAxis axisOver(const StepOverMesh& mesh, const std::vector<std::uint32_t>& nodes, int rounds);

/** Arc length at each point, step-overs. */
std::vector<double> arcsOf(const FingerAxis& axis);

/** The points of \p axis with arc lengths from \p from to \p to; the one in their middle where there are none. */
FingerAxis partOf(const FingerAxis& axis, double from, double to);

} // namespace pcl_spiral
