// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths and programs whose shank and holder touch nothing while the cutter cuts.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/led_tool.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/planning/spiral_plan.h>
#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/lead_check.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace pcl_spiral {

/** What is checked, and what is done about a collision. */
struct ToolWay {
  LedTool tool;                                    ///< its shank and holder
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points; ///< everything that the scan has
  SurfaceMesh::ConstPtr mesh;                      ///< instead of points
  Diagnostic remedy;                               ///< for messages
  ProgressCallback progress;                       ///< may be empty
  bool is_ball = false;                            ///< the flank is the shank, and the holder begins at its end
};

/** What \p tool would do at the place of \p collision: which part of it, how deep, where. */
Diagnostic collisionText(const LedTool& tool, const LeadCollision& collision);

/** The end of a warning about collisions with echoes alone. */
constexpr const char* only_echoes =
    ": only single points off the scanned surface are there, usually false echoes; check that nothing else is there";

/** The way of the tool of \p plan, against the whole mesh, or the whole scan without the clusters that are left out as false echoes. */
ToolWay wayOf(const SpiralPlan& plan);

/** The same, against the mesh, or the points that the cutter stays off and those that were left out by their place. */
ToolWay wayOf(const PassPlan& plan);

/** Looks at the moves of \p passes, straight from pose to pose. Where only single points off the scan's surface are in their way, or
 *  collisions are accepted, that goes to \p warnings; else it is Failed with the deepest place. */
Status checkToolWay(const ToolWay& way, const std::vector<ToolPoses>& passes, Diagnostics& warnings);

/** The same for the cutting moves of \p program, as the machine makes them: with axes that are blended at its pole. */
Status checkToolWay(const ToolWay& way, const MachineProgram& program, Diagnostics& warnings);

} // namespace pcl_spiral
