// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far apart neighbouring rows of parallel planes may be if a ball cuts a curved surface.
 */
#pragma once

#include <Eigen/Core>

namespace pcl_spiral {

/** What lies in the planes of the rows. */
enum class RowsThrough {
  Contacts, ///< where the ball touches
  Centres   ///< the centre of the ball, and so the tool axis: the ball is lowered along an axis that lies in the planes
};

/** The surface at a place. Curvatures in 1/mm, positive where convex. */
struct SurfaceBend {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();     ///< unit, out of the material
  Eigen::Vector3d direction1 = Eigen::Vector3d::UnitX(); ///< unit, principal direction of curvature1
  double curvature1 = 0.0, curvature2 = 0.0;             ///< curvature2 is across direction1
};

/** The largest distance, mm, of the two planes with unit normal \p across between which a ball of \p radius
 * leaves a ridge of \p height at the place. 0 where surface and planes are parallel; infinite where the ball
 * does not fit, which no row distance can change.
 *
 *  With n the normal of the surface, m that of the planes, t = n x m / |n x m| along the rows and
 * w = t x n across them; k_w, k_t the normal curvatures and T the geodesic torsion. A ball that touches at
 * a small distance e from the place leaves a height of e'(S + I/R) e / 2 there, S the shape operator. So rows are a
 * step L along the surface apart, L = stepOver(R, k, h), where
 *  - Contacts: k = k_w - T^2 / (k_t + 1/R), the least of that height along a row: its lowest ball is not
 * straight beside the place. The chord of L across is c = 2 sin(k L / 2) / k, at most the diameter;
 * the ridge is at its middle, where the surface leans by w.m, so D = c w.m = c sqrt(1 - (n.m)^2);
 *  - Centres: k = k_w, T has no effect: centres lie on the offset surface at R, whose shape is S (I + R S)^-1, so
 *    that the height is v'(I + R S)^-1 v / 2R for a centre at the offset v. Normals of the contacts differ by
 *    2 sin(k L / 2) w, so centres are R times that farther apart: D = (1 + R k) c w.m.
 * Exact on spheres, cylinders and planes, except for the change of k over a step. */
double rowDistance(const SurfaceBend& place, const Eigen::Vector3d& across, double radius, double height, RowsThrough through);

} // namespace pcl_spiral
