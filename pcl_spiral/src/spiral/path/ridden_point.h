// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A point of a path with its ball. Private to spiral.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A point of the path with its ball; mm. */
struct RiddenPoint {
  Eigen::Vector3d foot, normal, centre;
  float turn = 0.0f;
  std::uint8_t over_gap = 0;
  bool begins_pass = false;
  bool fresh = false; ///< the move to it is still to be checked
  bool lifted = false;

  /** Where the ball of \p radius touches, seen along the normal: centre = contact + radius normal. */
  Eigen::Vector3d contact(double radius) const { return lifted ? Eigen::Vector3d(centre - radius * normal) : foot; }
};

using RiddenPath = std::vector<RiddenPoint>;

} // namespace pcl_spiral
