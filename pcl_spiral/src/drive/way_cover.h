// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a ball touches triangles on its way. Private.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Part of a way, in shares of its length. */
struct WayPart {
  double first = 0.0, last = 1.0;
};

/** Collects the parts of a straight way, from the origin, where triangles are within reach of it. */
class WayCover {
public:
  explicit WayCover(const Eigen::Vector3d& way) : way_(way) {}

  /** Add the part where a flat triangle is within \p reach: its face, edges and corners. It is one part, for both are convex. */
  void add(const Eigen::Matrix3d& corners, double reach);
  bool isWhole();

private:
  bool clipToReach(const Eigen::Vector3d& place, const Eigen::Vector3d& way, double reach, WayPart& part) const;
  WayPart onFace(const Eigen::Matrix3d& corners, double reach) const;
  WayPart onEdge(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double reach) const;

  Eigen::Vector3d way_;
  std::vector<WayPart> parts_;
};

} // namespace pcl_spiral
