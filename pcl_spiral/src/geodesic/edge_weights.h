// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Weights of the edges of a triangulation for the Laplace equation.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <vector>

namespace pcl_spiral {

/** Dual length divided by length of every half-edge's edge, the same on both sides: cotangent weights (Pinkall and Polthier
 *  1993), made positive.
 *
 *  Slivers along the boundary are left out, because their dual edges lie outside it. An edge that is not Delaunay, of
 *  which a cloud's stars leave few, keeps a very small weight. So a solution is everywhere a mean of its neighbours and has no
 *  extremum of its own.
 */
std::vector<double> edgeWeights(const SurfaceGraph& graph);

} // namespace pcl_spiral
