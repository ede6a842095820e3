// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drive points, which guide a cutter, and passes of them.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A position and the tool axis there. With a normal, the position is the required contact: the cutter stands where
 * its profile touches it. Without a normal, the axis passes through the position, and the cutter moves down along
 * the axis until it touches the surface anywhere. Lengths in mm. */
struct DrivePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< the required contact, or a place of the axis
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();    ///< from the tip to the shank; any length except 0
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< of the surface, out of the material; zero: no contact is required

  bool asksForContact() const { return !normal.isZero(0.0); } ///< Whether there is a normal.
};

using DrivePoints = std::vector<DrivePoint>; ///< Drive points in any order; in a DrivePass, in travel order.

/** Drive points in travel order. The tool follows them without leaving the surface. */
struct DrivePass {
  DrivePoints points;  ///< in travel order
  bool closed = false; ///< the last point joins the first, which is not repeated
};

using DrivePasses = std::vector<DrivePass>; ///< Passes in travel order: the tool is lifted between them.

/** How the distance between section planes is chosen. */
enum class DriveRows {
  Even, ///< all equal, from the step-over
  Kept  ///< each one for the ridge it leaves, from slope and curvature of the surface there
};

} // namespace pcl_spiral
