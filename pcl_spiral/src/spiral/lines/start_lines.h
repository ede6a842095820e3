// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rough shortest lines from a centre: the start of geodesics.
 */
#pragma once

#include "geodesic/distance_field.h"
#include <pcl_spiral/core/polyline.h>

#include <memory>

namespace pcl_spiral {

/** Lines down the distance field of a centre. They only need the right direction, so in a large cloud one point in 32,
 *  evenly spread, carries the field: a thirtieth of the time. The graph must outlive the object. */
class StartLines {
public:
  /** Lines about \p graph; the field is not computed yet. */
  explicit StartLines(const SurfaceGraph& graph);

  /** Compute the field of \p centre; false when it is farther than three spacings from the cloud. */
  bool setCentre(const Eigen::Vector3d& centre);
  /** Let every point carry the field from now on: for lines that left the surface with the coarse field. */
  void useEveryPoint();
  bool usesEveryPoint() const { return !coarse_; }
  /** Spacing of the points that carry the field, mm. */
  double spacing() const;

  /** Line from \p from, at most a few spacings from the centre, to \p place. Empty when no way leads there. */
  Polyline between(const Eigen::Vector3d& from, const Eigen::Vector3d& place) const;

private:
  const SurfaceGraph* graph_;
  std::shared_ptr<const SurfaceGraph> coarse_; ///< null: every point is used
  DistanceField field_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
};

} // namespace pcl_spiral
