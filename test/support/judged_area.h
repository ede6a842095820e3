// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The area of a surface that a path must machine, and the least length of a path over it. Lengths in mm.
 */
#pragma once

#include "support/move_tree.h"
#include "support/surfaces.h"

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral::test {

/** A surface inside closed rims, the outer rim and any holes, given in space and compared in the chart of the surface.
 */
class JudgedArea {
public:
  JudgedArea(const AnalyticSurface& surface, const std::vector<Polyline>& rims);

  /** Whether the point of the surface at \p x is inside the rims. */
  bool contains(const Eigen::Vector3d& x) const { return region_.contains(surface_.chart(x)); }
  /** Straight distance to the nearest rim. */
  double rimDistance(const Eigen::Vector3d& x) const;
  /** Length of all rims. */
  double rimLength() const;
  /** Integral of dA / s + rims / 2.
   *
   *  s is the largest exact step-over of a ball of \p radius that leaves \p scallop. It is the step-over across the
   *  direction of the least normal curvature k: s = 4 asin(k c / 2) / k,
   *  c^2 = (2 R h - h^2) / ((1 + k R) (1 + k h)), convex positive. A pass on the rim covers only one side.
   */
  double leastLength(double radius, double scallop) const;

private:
  const AnalyticSurface& surface_;
  Region region_;
  std::vector<MoveTree> rims_;
};

/** For every outline of \p truth the loop that runs along it, no loop twice. If no loop follows an outline
 *  within \p tolerance in the mean, both ways, the outline itself is used and counted in \p missed. */
std::vector<Polyline> rimsAlong(const std::vector<Polyline>& truth, std::vector<Polyline> loops, double tolerance, std::size_t& missed);

} // namespace pcl_spiral::test
