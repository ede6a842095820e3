// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Polygons extended without end along an axis.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** All places over and under a polygon: the polygon moved along an axis, without end both ways. Lengths in mm. */
class Prism {
public:
  /** The polygon through \p corners in order; the last one is connected to the first. \p axis need not be a unit vector. */
  Prism(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& axis);

  /** Distance of \p place from the prism, square to the axis; 0 inside. */
  double distance(const Eigen::Vector3d& place) const;
  /** Distance of the straight line from \p begin to \p end from the prism, square to the axis; 0 if it enters. */
  double distance(const Eigen::Vector3d& begin, const Eigen::Vector3d& end) const;
  /** True if \p place is inside, by the rule of odd crossings; places on a side may be either. */
  bool contains(const Eigen::Vector3d& place) const;

  /** Places on the sides in order, at most \p step apart, in the plane through the origin square to the axis. */
  std::vector<Eigen::Vector3d> outline(double step) const;

  /** Largest distance of two corners, square to the axis. */
  double width() const;

  const Eigen::Vector3d& axis() const { return axis_; } ///< As a unit vector.
  /** Empty, or what is wrong with the polygon: fewer than three different corners, no area, or sides that cross, with the place. */
  const Diagnostic& fault() const { return fault_; }

private:
  Eigen::Vector2d flat(const Eigen::Vector3d& place) const { return {across_[0].dot(place), across_[1].dot(place)}; }
  Diagnostic findFault(const std::vector<Eigen::Vector3d>& corners) const;

  Eigen::Vector3d axis_;
  Eigen::Vector3d across_[2];            ///< unit vectors square to the axis and to each other
  std::vector<Eigen::Vector2d> corners_; ///< along them
  Diagnostic fault_;
};

/** Area of the polygon through \p corners as a vector along its mean normal (Newell 1972), mm2. */
Eigen::Vector3d polygonArea(const std::vector<Eigen::Vector3d>& corners);

} // namespace pcl_spiral
