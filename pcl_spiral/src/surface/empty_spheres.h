// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a ball surely reaches the points of a scan. Private.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Whether the spheres on the outer side of the points of \p graph, a quarter larger than a ball of \p radius and tangent to the surface
 *  at them, are empty, so that the ball reaches the surface at each. Points within \p own of a point count only where they are farther
 *  than a spacing from it and deeper in its sphere than \p noise; all in mm. False at the first point that is found in one, and if the
 *  points lie so close together that fitting the surface is as fast as looking. A ball that presses on a place at distance d is
 *  d^2 / (10 radius) deeper in the larger sphere: by so much the normal and the place of a point may be off. */
bool spheresAreEmpty(const SurfaceGraph& graph, double radius, double own, double noise);

/** For each of \p points, whether none of them lies in the sphere of \p radius that is tangent there on the side of its normal, deeper than
 *  the depth asked of it in \p depths, mm. The point itself lies on the sphere, at depth 0, and counts where less is asked. The depth of a
 *  point at distance d from the centre is (radius^2 - d^2) / (2 radius). Zero, too, where so many points are near the spheres that a
 *  search takes less time than to look at them. */
std::vector<std::uint8_t> emptySpheres(const PointBlocks& points, const std::vector<Eigen::Vector3f>& normals, double radius,
                                       const std::vector<float>& depths);

} // namespace pcl_spiral
