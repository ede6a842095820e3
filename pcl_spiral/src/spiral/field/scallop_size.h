// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How large a path at constant scallop would become, foretold before it is made.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/spiral/step_over_field.h>
#include <pcl_spiral/surface/surface.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Refuse a \p mesh whose \p chosen triangles are each to be cut into \p parts * \p parts where there is no memory for it. */
Status checkMeshSize(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen, int parts, const StepOverOptions& options);

/** What the path over \p field will ask for: points by its least length and the moves that the chord error of \p settings allows
 *  in either principal direction, knots by the edges of the mesh that its loops cross. */
PathSize scallopPathSize(const StepOverDistance& field, const Surface& surface, const SpiralSettings& settings);

} // namespace pcl_spiral
