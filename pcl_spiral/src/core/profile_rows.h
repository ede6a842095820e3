// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far apart neighbouring rows of parallel planes may be if any cutter of revolution cuts a curved surface.
 */
#pragma once

#include "row_distance.h"
#include <pcl_spiral/core/cutter_profile.h>

#include <vector>

namespace pcl_spiral {

/** What a cutter cuts beside a straight pass over a plane, seen along the pass. */
class PassSection {
public:
  /** The cutter touches a plane with \p normal, its tool along \p axis, and moves along \p travel in this plane. All unit.
   *  \p height: the largest ridge of interest, mm, by which the section is sampled. */
  PassSection(const CutterProfile& profile, const Eigen::Vector3d& axis, const Eigen::Vector3d& normal, const Eigen::Vector3d& travel,
              double height);

  /** Distance between two such passes along the plane, mm, that leaves a ridge of \p height on a surface of \p curvature across
   *  them: where the parabola of the surface is left by that height, on one side of the contact and on the other. */
  double width(double height, double curvature = 0.0) const { return reach(height, curvature, 1) + reach(height, curvature, -1); }

private:
  double reach(double height, double curvature, int side) const;

  std::vector<Eigen::Vector2d> sides_[2]; ///< from the contact away from it, to either side: distance and height above the plane
};

/** As rowDistance, for any cutter. Tool along \p axis. Exact on planes. Where convex, the surface falls off as a parabola. Where
 *  concave by more than \p flattest, 1/mm, a disc at the tip stands on its edge: it does not count, and rows through centres come
 *  nearer, as those of a ball of the corner radius. */
double profileRowDistance(const SurfaceBend& place, const Eigen::Vector3d& across, const CutterProfile& profile,
                          const Eigen::Vector3d& axis, double height, RowsThrough through, double flattest);

} // namespace pcl_spiral
