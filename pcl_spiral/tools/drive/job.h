// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What one run of pcl_spiral_drive is asked to do.
 */
#pragma once

#include "passes/pass_job.h"

#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <optional>
#include <string>

/** A run as the user described it. Lengths mm, angles degrees. */
struct Job : PassJob {
  bool mesh = false; ///< the scan is a mesh, and its faces count
  pcl_spiral::MeshSettings mesh_settings;
  bool no_gouge_check = false; ///< stand the cutter at the contacts of a mesh without a look at the rest of it
  pcl_spiral::DriveSettings drive;
  std::string curve_file;
  std::optional<Eigen::Vector3d> column_axis;              ///< direction; found from the scan where none is given
  Eigen::Vector3d column_centre = Eigen::Vector3d::Zero(); ///< a place on it
  double scallop = 0.0;                                    ///< in place of a step-over
  bool one_way = false;
};
