// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_drive.
 */
#pragma once

#include "passes/pass_job.h"
#include "terminal/region_choice.h"

#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <optional>
#include <string>

/** The user's settings for one run. Lengths in mm, angles in degrees. */
struct Job : PassJob {
  bool mesh = false; ///< the scan is a mesh, and its faces are used
  pcl_spiral::MeshSettings mesh_settings;
  bool no_gouge_check = false; ///< put the cutter at the contacts of a mesh without checking the rest of it
  pcl_spiral::DriveSettings drive;
  std::string curve_file;
  std::string raw_scan;                                    ///< before it was smoothed; empty: not given
  std::optional<Eigen::Vector3d> column_axis;              ///< direction; found from the scan if not given
  Eigen::Vector3d column_centre = Eigen::Vector3d::Zero(); ///< a place on it
  bool one_way = false;
  RegionChoice regions; ///< several of them are cut one after the other
};
