// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether short lines on a surface cross, seen in a plane.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace pcl_spiral {

/** Lines about a place, in the plane of two directions there. */
class PlaneLines {
public:
  PlaneLines(const Eigen::Vector3d& origin, const Eigen::Vector3d& along, const Eigen::Vector3d& across);

  /** An open line that must not be crossed. */
  void add(const Polyline& line);
  /** Whether a move of \p line crosses one of the lines; lines that only meet at an end do not cross. */
  bool crossedBy(const Polyline& line) const;

private:
  using Segment = std::array<Eigen::Vector2d, 2>;
  Eigen::Vector2d inPlane(const Eigen::Vector3d& p) const;

  Eigen::Vector3d origin_, e1_, e2_;
  std::vector<Segment> segments_;
};

} // namespace pcl_spiral
