// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The distance from the rims of a mesh.
 */
#pragma once

#include <pcl_spiral/spiral/step_over_field.h>

namespace pcl_spiral {

/** What measureStepOvers does once it has made \p mesh of a surface (makeStepOverMesh), which may be gone by then. \p spacing: of its
 *  points, mm. */
Status measureOnMesh(StepOverMesh mesh, double spacing, const StepOverOptions& options, StepOverDistance& field,
                     const ProgressCallback& progress);

} // namespace pcl_spiral
