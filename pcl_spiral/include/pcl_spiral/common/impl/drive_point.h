// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drive points: positions with a tool axis each, which guide the cutter.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A position and the tool axis there. With a normal, the position is the required contact: the cutter stands where
 * its profile touches it. Without a normal, the axis passes through the position, and the cutter moves down along
 * the axis until it touches the surface anywhere. Lengths in mm. */
struct DrivePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< from the tip to the shank; any length except 0
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< of the surface, out of the material; zero: no contact is required

  bool asksForContact() const { return !normal.isZero(0.0); }
};

using DrivePoints = std::vector<DrivePoint>;

} // namespace pcl_spiral
