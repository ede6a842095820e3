/** \file
 *  Distances of neighbouring passes.
 */
#pragma once

namespace pcl_spiral {

/** How far section planes are apart. */
enum class DriveRows {
  Even, ///< all alike, as the step-over says
  Kept  ///< as the ridge between any two asks, by slope and curvature of the surface there
};

} // namespace pcl_spiral
