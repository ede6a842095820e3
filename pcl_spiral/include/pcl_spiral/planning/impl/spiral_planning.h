// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a scan or a mesh, and the choice of its part, to a plan.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/planning/spiral_plan.h>
#include <pcl_spiral/spiral/path_planner.h>

#include <pcl/pcl_base.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What is planned. Either a scan or a mesh is given. */
struct PlanInput {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;             ///< the scan
  pcl::PointCloud<pcl::Normal>::ConstPtr normals;             ///< one for each point; null: none
  pcl::IndicesPtr indices;                                    ///< points of the part; null: all
  SurfaceMesh::ConstPtr mesh;                                 ///< null: the scan counts
  double sample_spacing = 0.0;                                ///< of the samples of the mesh, mm; 0: found from the mesh
  PartChoice choice;                                          ///< without its region
  std::vector<PlanRegion> regions;                            ///< none: all that the choice leaves
  SpiralSettings settings;                                    ///< clusters and part_at of the choice are not taken from here
  std::vector<std::shared_ptr<const PathModifier>> modifiers; ///< of every path
  std::shared_ptr<const PathPlanner> planner;                 ///< in place of the spiral; null: none
  double flank_length = 0.0;                                  ///< between the centre of the ball and the holder, mm
  std::vector<ToolSegment> holder;                            ///< none: shank and holder are not looked at
  double holder_clearance = 0.0;                              ///< mm
  bool accept_collisions = false;                             ///< of shank and holder: they are warnings
  bool ball_closing = false;                                  ///< the scan is closed by the ball along the tool axis
  bool keep_surface = false;                                  ///< the plan has the surface of each region
  std::set<std::string> asked;                                ///< what else was asked for: names of idle_settings.h
  int remedy_tries = 3;                                       ///< about how many paths a search for a change that helps may cost
  std::shared_ptr<Surface::ConstPtr> kept_surface;            ///< where the surface is kept from plan to plan; null: it is not
  std::shared_ptr<double> paths_left;                         ///< how many paths tries may still cost; null: no bound
  ProgressCallback progress;                                  ///< may be empty
};

/** Plans every region. \p plan has an empty path if the status is not ok. */
Status planSpiral(const PlanInput& input, SpiralPlan& plan);

} // namespace pcl_spiral
