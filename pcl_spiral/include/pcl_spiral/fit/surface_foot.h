// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The foot of a point on a surface.
 */
#pragma once

#include <Eigen/Geometry>

#include <cstdint>

namespace pcl_spiral {

/** The foot of a point on the surface, and the shape of the surface there. Curvatures are positive where the surface is
 *  convex (curves away from its normal). */
struct SurfaceFoot {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    ///< on the surface, mm
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();     ///< unit, out of the material
  Eigen::Vector3d direction1 = Eigen::Vector3d::UnitX(); ///< unit, principal direction of curvature1
  double curvature1 = 0.0;                               ///< the larger principal curvature, 1/mm
  double curvature2 = 0.0;                               ///< the smaller, across direction1
  double residual = 0.0;                                 ///< standard deviation of the cloud about the fit here, mm
  double overhang = 0.0;                                 ///< distance beyond the outermost points of the cloud, mm; 0 inside
  double nearest_distance = 0.0;                         ///< from the nearest point of the cloud, mm
  std::uint32_t nearest = 0;                             ///< index of that point, in the order of the graph
  bool valid = false;                                    ///< false far from the cloud, beyond its rim, or where the fit is not determined

  /** Normal curvature in the tangent direction \p t (unit), by Euler's theorem. */
  double normalCurvature(const Eigen::Vector3d& t) const
  {
    const double c = t.dot(direction1), s = t.dot(normal.cross(direction1));
    const double whole = c * c + s * s;
    return whole > 0.0 ? (curvature1 * c * c + curvature2 * s * s) / whole : 0.5 * (curvature1 + curvature2);
  }
  double gaussCurvature() const { return curvature1 * curvature2; } ///< Product of both curvatures, 1/mm^2.
};

/** Type of the fitted surface. */
enum class ProjectionMethod {
  Quadratic,          ///< local quadric with a compact C2 weight, iterated
  RobustQuartic,      ///< fourth degree where the noise is low enough to tell it from the quadric, without outliers;
                      ///< used to check a path
  DirectionalCentroid ///< as published (Wu et al. 2025, equations 8-11): order zero, biased by (k1 + k2) h^2 / 4
};

} // namespace pcl_spiral
