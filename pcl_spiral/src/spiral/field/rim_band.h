// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A surface continued straight beyond its rim. Private to spiral.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Rays from a closed outline out of the surface, along its tangent planes. */
class RimBand {
public:
  /** \p curve lies on \p surface, which is on its left. */
  RimBand(const Surface& surface, const Polyline& curve);

  /** The closed line \p distance mm beyond the outline: the ends of the rays without those closer to the outline elsewhere, as in
   *  its bays. Points are at most \p step apart. */
  Polyline line(double distance, double step) const;
  /** Points of the band out to \p distance, in rows one spacing apart. */
  std::vector<Eigen::Vector3f> points(double distance) const;

private:
  struct Ray {
    Eigen::Vector3d from, along;
  };
  double distanceTo(const Eigen::Vector3d& place) const;

  Polyline curve_;
  std::vector<Ray> rays_;
  double spacing_;
};

} // namespace pcl_spiral
