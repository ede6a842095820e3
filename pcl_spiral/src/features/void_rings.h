// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rings of a surface with its narrow holes open. Private to features.
 */
#pragma once

#include "loop_rings.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** boundaryRings of part 0 of the graph's triangles, given the part \p part_of each, without the triangles that close voids
 *  at least \p width mm wide (ScanVoids). */
std::vector<Ring> ringsWithVoids(const SurfaceGraph& graph, const std::vector<std::uint32_t>& part_of, double width);

} // namespace pcl_spiral
