// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Straight edges of round faces. Private to mesh.
 */
#pragma once

#include "flat_regions.h"

namespace pcl_spiral {

/** Where an edge, and all edges beside it, are much longer than the mesh behind their common vertex, the edge is straight by the rule of
 *  flat regions: \p normals there become perpendicular to it. So are the rulings of a wall above a fillet. */
void straightenRulings(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions, const std::vector<std::uint8_t>& creases,
                       const CornerSectors& sectors, const FlatRegions& regions, std::vector<Eigen::Vector3d>& normals);

} // namespace pcl_spiral
