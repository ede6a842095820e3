// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Predicts how large a path at constant scallop would become, before it is made.
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

/** Each of the \p chosen triangles of \p mesh is to be cut into \p parts * \p parts: refuse if there is not enough memory. */
Status checkMeshSize(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen, int parts, const StepOverOptions& options);

/** Size of the path over \p field: points from its least length and the moves that the chord error of \p settings allows in either
 *  principal direction, knots from the edges of the mesh that its loops cross. */
PathSize scallopPathSize(const StepOverDistance& field, const Surface& surface, const SpiralSettings& settings);

} // namespace pcl_spiral
