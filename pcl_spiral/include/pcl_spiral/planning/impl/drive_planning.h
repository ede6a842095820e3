// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan or a mesh, and the choice of its part, to passes of a cutter.
 */
#pragma once

#include <pcl_spiral/planning/pass_plan.h>

#include <pcl/pcl_base.h>

#include <vector>

namespace pcl_spiral {

/** What is planned. Either a scan or a mesh is given. */
struct DrivePlanInput {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< the scan
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< one for each point; null: none
  pcl::IndicesPtr indices;                        ///< points of the part; null: all
  SurfaceSettings surface;                        ///< of the scan
  bool leave_out_strays = false;                  ///< points off the scanned surface are left out first
  SurfaceMesh::ConstPtr mesh;                     ///< null: the scan counts
  bool sample_mesh = false;                       ///< the plan has samples of the mesh, as checks of leads need them
  bool check_gouges = true;                       ///< false: the cutter stands at the contacts of the mesh
  PartChoice choice;                              ///< without its region
  std::vector<PlanRegion> regions;                ///< none: all that the choice leaves
  DrivePasses passes;                             ///< of the user's own; empty: those of drive
  DriveSettings drive;                            ///< scallop_height above 0: what the passes leave is checked
  PassSettings tool;                              ///< its cutter is that of drive
  ProgressCallback progress;                      ///< may be empty
};

/** Plans the passes of every region. \p plan has none if the status is not ok. */
Status planDrivePasses(const DrivePlanInput& input, PassPlan& plan);

} // namespace pcl_spiral
