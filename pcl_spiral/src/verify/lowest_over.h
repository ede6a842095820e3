// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter is deepest below a surface next to a foot. Private to verify.
 */
#pragma once

#include <pcl_spiral/verify/impl/cutter_sweep.h>
#include <pcl_spiral/verify/impl/profile_depth.h>

namespace pcl_spiral {

/** Height of the cutter at \p tip along the unit \p axis above the quadric about \p foot: minus the depth of its deepest place within
 *  \p reach, and this place. Searched as if the depth were concave over the quadric, as it is on planes and domes, and at 25 places. */
SurfaceHeight lowestOver(const ProfileDepth& profile, const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, const SurfaceFoot& foot,
                         double reach);

} // namespace pcl_spiral
