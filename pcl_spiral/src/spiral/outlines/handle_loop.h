// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a triangulation has a handle.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Twice the number of handles of a connected triangulation of \p positions no node of which has two fans: what V - E + F and
 *  the number of its boundary loops lack of 2. */
std::size_t missingEuler(const Polyline& positions, const Triangulation& triangles);

/** Nodes of a short closed way that does not part the triangles, in its order: along it a handle can be cut through. Empty where
 *  there is no handle. Way back to itself by the shortest ways from a node and a maximum spanning tree of the triangles, boundary
 *  loops closed (Erickson, Whittlesey, Greedy optimal homotopy and homology generators, 2005, section 3); the node is then moved
 *  onto the way found, three times. */
std::vector<std::uint32_t> handleLoop(const Polyline& positions, const Triangulation& triangles);

} // namespace pcl_spiral
