// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parabolas instead of the straight edges of a triangle mesh.
 *
 *  An edge leads from P0 to P1 = P0 + d; n0 and n1 are the unit normals of the surface there. Its parabola is
 *  C(u) = P0 + d u - bow u (1 - u) for u from 0 to 1. The bow, times u (1 - u), is the distance of the surface behind the straight
 *  edge; in the middle a quarter of the bow. Lengths in mm. */
#pragma once

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** Height of the mean slope: half the difference of the slopes of both tangent planes along the edge, measured along \p mean,
 *  (n0.d / n0.mean - n1.d / n1.mean) / 2: positive where the surface is hollow. nullopt if the normal at an end is perpendicular
 *  to \p mean or points away from it: the slope is not defined then. */
std::optional<double> meanSlope(const Eigen::Vector3d& d, const Eigen::Vector3d& n0, const Eigen::Vector3d& n1,
                                const Eigen::Vector3d& mean);

/** Bow along the mean normal n: meanSlope(d, n0, n1, n) n. On a sphere of radius rho, an edge of the angle phi has the error
 *  rho phi^4 / 128 in the middle, the straight edge rho phi^2 / 8. Zero where the normals differ by 90 degrees or more. */
Eigen::Vector3d robustBow(const Eigen::Vector3d& d, const Eigen::Vector3d& n0, const Eigen::Vector3d& n1);

/** Bow with the control point where the edge's projections on both tangent planes meet. They are skew, so the control point is
 *  midway between their nearest points. Zero where they are parallel. Source: Sun, Li, Li, Liu, High precision and fast generation
 *  algorithm of NC tool path for triangular mesh surface, Trans. CSAM 41(7), 2010, equation (3). */
Eigen::Vector3d publishedBow(const Eigen::Vector3d& d, const Eigen::Vector3d& n0, const Eigen::Vector3d& n1);

/** Bow of a crease, where two surfaces meet, each with its own normals at both ends. The edge bows in each surface as that
 *  surface does. Zero where the surfaces fold together or continue each other (normals within 5 degrees of one line). */
Eigen::Vector3d creaseBow(const Eigen::Vector3d& d, const Eigen::Vector3d& n0, const Eigen::Vector3d& n1, const Eigen::Vector3d& m0,
                          const Eigen::Vector3d& m1);

/** Where a parabola reaches \p level, as u from 0 to 1, if its ends lie on both sides of it: v0 < level <= v1 or the other way
 *  round. \p v0 and \p v1 are the values of a linear function at its ends; \p bow is the function's value of the bow (without the
 *  constant). There is exactly one such u, in closed form. */
double parabolaCrossing(double v0, double v1, double bow, double level);

} // namespace pcl_spiral
