/** \file
 *  What drives a cutter: places with a tool axis each.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** A place and the tool axis there. With a normal, the place is the contact that is asked for, and the cutter
 * stands where its profile touches it. Without one, the axis runs through the place and the cutter comes down
 * along it until it touches, wherever that is. Lengths in mm. */
struct DrivePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< from the tip to the shank; of any length but 0
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero(); ///< of the surface, out of the material; zero: no contact is asked for

  bool
  asksForContact() const
  {
    return !normal.isZero(0.0);
  }
};

using DrivePoints = std::vector<DrivePoint>;

} // namespace pcl_spiral
