// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds a handle of a triangulation.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Twice the number of handles of a connected triangulation of \p positions without nodes that have two fans: 2 minus V - E + F
 *  minus the number of boundary loops. */
std::size_t missingEuler(const Polyline& positions, const Triangulation& triangles);

/** Nodes, in order, of a short closed way that does not separate the triangles: a cut along it opens a handle. Empty if there is
 *  no handle. The way comes from the shortest ways from a node and a maximum spanning tree of the triangles, with boundary loops
 *  closed (Erickson, Whittlesey, Greedy optimal homotopy and homology generators, 2005, section 3). The node is then moved onto
 *  the way found, three times. */
std::vector<std::uint32_t> handleLoop(const Polyline& positions, const Triangulation& triangles);

} // namespace pcl_spiral
