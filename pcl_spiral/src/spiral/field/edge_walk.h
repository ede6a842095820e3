// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distances along the edges of a mesh.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Length of the shortest way along edges from each node of \p mesh to the nearest one that is marked in \p from, step-overs. Beyond
 *  \p reach it is infinite, but for the first node of each way there. */
std::vector<float> walkedFrom(const StepOverMesh& mesh, const std::vector<std::uint8_t>& from, double reach);

} // namespace pcl_spiral
