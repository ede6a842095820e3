// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The boundary of a triangulation as rings of points. Private to features.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points of a closed run, in order. The surface is on the left. */
using Ring = std::vector<std::uint32_t>;

/** Split a closed run of points at those it visits more than once, into rings that do not touch themselves. */
std::vector<Ring> simpleRings(const Ring& run);

/** Simple rings round the triangles of part \p which (as given by Triangulation::parts). */
std::vector<Ring> boundaryRings(const Triangulation& mesh, const std::vector<std::uint32_t>& parts, std::uint32_t which);

/** Length of a ring, mm, and the area it encloses, mm2, seen from the direction where that is largest. */
double ringLength(const SurfaceGraph& graph, const Ring& ring);
double ringArea(const SurfaceGraph& graph, const Ring& ring);

/** Whether a ring is shorter than a loop must be, or so thin that it encloses less than such a loop. */
bool isFlaw(const SurfaceGraph& graph, const Ring& ring, double shortest);

/** The ring, started at the point farthest from its mean: the same point wherever the cloud lies. */
Ring begunFarOut(const SurfaceGraph& graph, Ring ring);

} // namespace pcl_spiral
