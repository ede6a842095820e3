// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distances between neighbouring rows.
 */
#pragma once

namespace pcl_spiral {

/** How the distance between section planes is chosen. */
enum class DriveRows {
  Even, ///< all equal, from the step-over
  Kept  ///< each one for the ridge it leaves, from slope and curvature of the surface there
};

} // namespace pcl_spiral
