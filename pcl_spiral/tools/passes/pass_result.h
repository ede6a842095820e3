// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of a program came to that makes passes of a tool.
 */
#pragma once

#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <optional>
#include <string>
#include <vector>

/** Passes and what is known of them. */
struct PassResult {
  pcl_spiral::Scan scan;                               ///< of a mesh the points it was sampled at, where they were needed
  pcl_spiral::SurfaceMesh::ConstPtr mesh;              ///< the part where it is a mesh; null for a scan
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole_scan; ///< with the strays that were left out
  pcl_spiral::LocationFigures locations;
  pcl_spiral::BisectionFigures bisection;
  std::vector<pcl_spiral::ToolPoses> passes; ///< in travel order, without locations off the part
  std::size_t off_scan = 0;                  ///< locations left out: nothing of the part below the cutter
  double length = 0.0;                       ///< of the tip's way along all passes, mm
  std::vector<pcl_spiral::StageCost> stages;
  std::vector<std::string> warnings;
  std::optional<pcl_spiral::MachineProgram> program; ///< where a machine is given

  std::size_t poseCount() const
  {
    std::size_t count = 0;
    for (const pcl_spiral::ToolPoses& pass : passes)
      count += pass.size();
    return count;
  }
};
