// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The part of a surface that a path has to machine, and the least length of a path over it. Lengths in mm.
 */
#pragma once

#include "support/move_tree.h"
#include "support/surfaces.h"

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral::test {

/** A surface within closed rims, the outer and any holes, given in space and compared in the surface's chart.
 */
class JudgedArea {
public:
  JudgedArea(const AnalyticSurface& surface, const std::vector<Polyline>& rims);

  /** Whether the point of the surface at \p x lies within the rims. */
  bool contains(const Eigen::Vector3d& x) const { return region_.contains(surface_.chart(x)); }
  /** Straight distance to the nearest rim. */
  double rimDistance(const Eigen::Vector3d& x) const;
  /** Length of all rims. */
  double rimLength() const;
  /** Integral of dA / s + rims / 2.
   *
   *  s is the largest exact step-over of a ball of \p radius that leaves \p scallop, which is that across the
   *  direction of the least normal curvature k: s = 4 asin(k c / 2) / k,
   *  c^2 = (2 R h - h^2) / ((1 + k R) (1 + k h)), convex positive. A pass on the rim covers one side alone.
   */
  double leastLength(double radius, double scallop) const;

private:
  const AnalyticSurface& surface_;
  Region region_;
  std::vector<MoveTree> rims_;
};

/** For every outline of \p truth the loop that runs along it, no loop twice. An outline that no loop follows
 *  within \p tolerance in the mean, both ways, stands for itself and is counted in \p missed. */
std::vector<Polyline> rimsAlong(const std::vector<Polyline>& truth, std::vector<Polyline> loops, double tolerance, std::size_t& missed);

} // namespace pcl_spiral::test
