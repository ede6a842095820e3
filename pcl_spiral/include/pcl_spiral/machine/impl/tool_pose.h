// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Position of the tool: tip and axis.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** The unit vector at share \p t of the arc from \p a to \p b, both unit; for opposite vectors, which have no arc: \p a. */
Eigen::Vector3d arcBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t);

/** The pose at share \p t of the straight move from \p a to \p b; axis and normal move along their arcs. */
ToolPose between(const ToolPose& a, const ToolPose& b, double t);

} // namespace pcl_spiral
