// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Smooth lines through nodes of the mesh.
 */
#pragma once

#include "finger_axes.h"

namespace pcl_spiral {

/** The line over \p nodes with points 0.05 step-overs apart, smoothed \p rounds times with fixed ends. */
FingerAxis axisOver(const StepOverMesh& mesh, const std::vector<std::uint32_t>& nodes, int rounds);

/** Arc length at each point, step-overs. */
std::vector<double> arcsOf(const FingerAxis& axis);

/** The points of \p axis with arc lengths from \p from to \p to; if there are none, the point in the middle. */
FingerAxis partOf(const FingerAxis& axis, double from, double to);

} // namespace pcl_spiral
