// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Curvature at a point of a surface from its neighbours and its normal. Private to spiral.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/search/neighbour_lists.h>

#include <optional>

namespace pcl_spiral {

/** Principal curvatures, 1/mm, positive where the surface is convex. */
struct PrincipalCurvatures {
  double larger = 0.0, smaller = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX(); ///< unit, of the larger; the other lies across it
};

/** Curvatures at \p point with unit \p normal (out of the material) from \p neighbours on the same surface.
 *
 *  Wu et al. 2025, equation (12), in the standard form of Taubin 1995, "Estimating the tensor of curvature of
 * a surface from a polyhedral approximation": along T_j = (p_j - p) made tangential, unit, kappa_j = 2 N .
 * (p_j - p) / |p_j - p|^2,   M = sum_j w_j kappa_j T_j T_j^T,   sum w_j = 1, and of the two eigenvalues m1,
 * m2 of M in the tangent plane k1 = 3 m1 - m2, k2 = 3 m2 - m1. The sign is turned round: Taubin's curvature
 * is positive where the surface bends towards N. His w_j is the area of the triangles at the edge to p_j,
 *  over all; here those are the triangles between p and two neighbours next to each other about N, none
 * across half a turn or more. Nothing with fewer than three neighbours, or without area. */
std::optional<PrincipalCurvatures> taubinCurvatures(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                                    const Polyline& neighbours);

/** The same at point \p i of a graph, with its PCA normal, from what \p edges join it to. */
std::optional<PrincipalCurvatures> taubinCurvatures(const SurfaceGraph& graph, const NeighbourLists& edges, std::uint32_t i);

} // namespace pcl_spiral
