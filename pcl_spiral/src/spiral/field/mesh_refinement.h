// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh that is finer in chosen places.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Cut each triangle of \p mesh with \p chosen not 0 into \p parts * \p parts, with 2 \p parts or more. Their neighbours become fans,
 *  so that the mesh has no cracks. New nodes lie on the old triangles. \p is_fine: one entry a node, 1 for nodes of cut triangles. */
StepOverMesh refined(StepOverMesh mesh, const std::vector<std::uint8_t>& chosen, int parts, std::vector<std::uint8_t>& is_fine);

} // namespace pcl_spiral
