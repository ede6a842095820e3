// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Edges of the elliptic Gabriel graph of points.
 */
#pragma once

#include <pcl_spiral/search/neighbour_lists.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** Settings of an elliptic Gabriel graph. Angles in radians. */
struct GabrielOptions {
  double alpha = 0.75;           ///< axis of the ellipsoid across the edge over the axis along it, in (0, sqrt 2]
  int candidates = 32;           ///< nearest neighbours of a point that can become its neighbours
  double max_edge = 3.5;         ///< in local spacings, the larger of the two ends; 0: any length
  double max_normal_angle = 0.0; ///< between the normals of the two ends; 0: any
  unsigned int threads = 0;      ///< 0: as many as a ThreadLimit leaves, or all; the result does not depend on it
};

/** Elliptic Gabriel graph (Park, Shin, Choi 2006): p and q are joined iff no other point lies inside the
 * ellipsoid of revolution with its centre midway between them, semi-axis L/2 along pq and alpha L/2 across.
 *
 *  Every blocker of an edge is nearer to p than q is (for alpha up to sqrt 2), so each candidate is tested
 * against the nearer neighbours. The test is therefore exact. An edge is missed only if neither end is among the
 * candidates of the other (0.1 % on a random plane at 32). Points on the ellipsoid do not block; points at the same
 * place are joined. With normals and an angle, points beyond this angle neither join nor block, so that
 * the two sides of a thin wall stay apart. The local spacing is that of the candidates if they are spread evenly
 * over a disc. Deterministic.
 *  \param points finite
 *  \param normals unit and consistently oriented, one per point; may be empty if max_normal_angle is 0
 *  \param options in range */
NeighbourLists ellipticGabrielEdges(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& normals,
                                    const GabrielOptions& options);

/** True if \p x lies inside the ellipsoid of the edge \p p \p q (axis ratio \p alpha); false for p and q
 * themselves. */
bool blocksEdge(const Eigen::Vector3d& x, const Eigen::Vector3d& p, const Eigen::Vector3d& q, double alpha);

} // namespace pcl_spiral
