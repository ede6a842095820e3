// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath for the checks, and places on it. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

/** Contacts with unit normals out of the material; turns may be empty. */
struct CheckedPath {
  std::vector<Eigen::Vector3d> contacts;
  std::vector<Eigen::Vector3d> normals;
  std::vector<double> turns;
  std::vector<std::size_t> lifted_to; ///< points that the tool is lifted to, ascending

  /** Whether the move from point \p move to the next one cuts nothing. */
  bool isLift(std::size_t move) const { return std::binary_search(lifted_to.begin(), lifted_to.end(), move + 1); }
  std::size_t size() const { return contacts.size(); }
  /** Turn at a point, or 0 if none was given. */
  double turn(std::size_t i) const { return i < turns.size() ? turns[i] : 0.0; }
};

/** A measured value and its place. */
struct Place {
  double value = 0.0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double rim = 0.0;      ///< distance to the true outline
  double turn = 0.0;     ///< of the path there
  std::size_t index = 0; ///< of the path point or move
};

/** The tool is lifted where the arc length does not change on the way to another place. */
CheckedPath fromToolpath(const pcl::PointCloud<ToolpathPoint>& path);

/** Value at the share \p q of the sorted order, nearest rank; reorders \p values. 0 if there are none. */
double quantile(std::vector<double>& values, double q);

/** Step-over that leaves the height \p h between balls of radius \p r across the normal curvature \p kappa
 * (convex positive); along the surface. Two balls with centres on the offset circle meet at height h.
 */
double exactStepOver(double r, double h, double kappa);

} // namespace pcl_spiral::test
