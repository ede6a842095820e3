// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How deep a place is in a cutter of revolution.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

/** Depth in a cutter: the least over all planes that bound it, whose flank ends at R and continues as a shank without end. So it is
 *  concave. Inside it is the shortest way out; outside, minus a lower bound of the distance, which is exact beside the corner. */
class ProfileDepth {
public:
  /** A depth, and the outward normal of the side that is nearest. */
  struct Side {
    double depth;         ///< mm; negative outside
    double across, along; ///< away from the axis and along it
  };

  explicit ProfileDepth(const CutterProfile& profile)
  : radius_(profile.radius()), corner_(profile.cornerRadius()), flat_(profile.flatRadius()), sine_(std::sin(profile.flankAngle())),
    cosine_(std::cos(profile.flankAngle()))
  {}

  /** At the distance \p l >= 0 from the axis and the height \p z above the tip. */
  Side at(double l, double z) const
  {
    const double u = l - flat_, v = z - corner_; // from the middle of the corner
    Side least{z, 0.0, -1.0};
    if (radius_ - l < least.depth)
      least = {radius_ - l, 1.0, 0.0};
    if (const double depth = corner_ - (u * cosine_ - v * sine_); depth < least.depth)
      least = {depth, cosine_, -sine_};
    if (u > 0.0 && v < 0.0 && -v * cosine_ >= u * sine_) { // between the normals of flat and flank
      const double from_middle = std::sqrt(u * u + v * v);
      if (corner_ - from_middle < least.depth)
        least = {corner_ - from_middle, u / from_middle, v / from_middle};
    }
    return least;
  }

  /** Of a point in space, for a cutter with its tip at \p tip along the unit \p axis. */
  double at(const Eigen::Vector3d& point, const Eigen::Vector3d& tip, const Eigen::Vector3d& axis) const
  {
    const double z = (point - tip).dot(axis);
    return at(std::sqrt(std::max(0.0, (point - tip).squaredNorm() - z * z)), z).depth;
  }

private:
  double radius_, corner_, flat_, sine_, cosine_;
};

} // namespace pcl_spiral
