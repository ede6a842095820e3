// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a surface is one. Private to features.
 */
#pragma once

#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Finds the part of each triangle (0 is the largest) and what is left out. Fails if there is no surface, or if
 *  parts larger than small clusters lie beside the largest one: the message names the parts and the remedy. */
Status checkParts(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<std::uint32_t>& part_of, BoundaryReport& counts);

} // namespace pcl_spiral
