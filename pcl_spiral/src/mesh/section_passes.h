// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Passes along the sections of a mesh. Private to mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** As MeshSections describes them; \p settings have been checked. */
Status sectionPasses(const SurfaceMesh& mesh, const SectionSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
                     SectionReport& report);

} // namespace pcl_spiral
