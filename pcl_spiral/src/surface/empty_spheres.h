// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a ball surely reaches every point of a scan. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

namespace pcl_spiral {

/** Whether the spheres on the outer side of the points of \p graph, a quarter larger than a ball of \p radius and tangent to the surface
 *  at them, are empty, so that the ball reaches the surface at each. Points within \p own of a point count only where they are farther
 *  than a spacing from it and deeper in its sphere than \p noise; all in mm. False at the first point that is found in one, and if the
 *  points lie so close together that fitting the surface is as fast as looking. A ball that presses on a place at distance d is
 *  d^2 / (10 radius) deeper in the larger sphere: by so much the normal and the place of a point may be off. */
bool spheresAreEmpty(const SurfaceGraph& graph, double radius, double own, double noise);

} // namespace pcl_spiral
