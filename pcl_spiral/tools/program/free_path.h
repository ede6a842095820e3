// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths and programs whose shank and holder touch nothing while the cutter cuts.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "free_leads.h"

#include <pcl_spiral/mesh/surface_mesh.h>

/** What is checked, and what is done about a collision. */
struct PathCheck {
  std::string file;                                ///< for messages
  LedTool tool;                                    ///< its shank and holder
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points; ///< everything that the scan has
  pcl_spiral::SurfaceMesh::ConstPtr mesh;          ///< instead of points
  pcl_spiral::Diagnostic remedy;                   ///< for messages
  bool accepted = false;                           ///< a collision is only a warning
  bool quiet = false;
};

/** Looks at the moves of \p passes, straight from pose to pose. Where only single points off the scan's surface are in their way, or
 *  collisions are accepted, that goes to \p warnings. \throw pcl_spiral::FileError, Cancelled */
void requireFreePath(const PathCheck& check, const std::vector<pcl_spiral::ToolPoses>& passes, pcl_spiral::Diagnostics& warnings);

/** The same for the cutting moves of \p program, as the machine makes them: with axes that are blended at its pole. */
void requireFreePath(const PathCheck& check, const pcl_spiral::MachineProgram& program, pcl_spiral::Diagnostics& warnings);
