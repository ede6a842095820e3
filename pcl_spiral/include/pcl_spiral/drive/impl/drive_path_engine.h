// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Plans drive paths over a scan.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Passes over \p surface, as DrivePath describes them. \p surface is null if DriveSettings::needsSurface() is false. */
Status planDrive(const Surface::ConstPtr& surface, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
                 DriveReport& report);

/** Passes over \p mesh, as DrivePath::setInputMesh describes them. */
Status planMeshDrive(const SurfaceMesh::ConstPtr& mesh, const DriveSettings& settings, const ProgressCallback& progress,
                     DrivePasses& passes, DriveReport& report);

} // namespace pcl_spiral
