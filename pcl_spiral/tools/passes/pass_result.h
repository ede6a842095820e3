// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The result of a program that makes passes of a tool.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "terminal/part_options.h"
#include "terminal/scan_side.h"

#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <optional>
#include <vector>

/** Locations left out because of what is not to be cut. Depths in mm. */
struct LeftOutLocations {
  std::size_t entering = 0; ///< the cutter would enter a keep-out
  std::size_t touching = 0; ///< the tool would touch what stands in a keep-out
  std::size_t beside = 0;   ///< the tool would touch the scan beside the part
  double deepest = 0.0, deepest_beside = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero(), first_beside = Eigen::Vector3d::Zero(); ///< places touched

  std::size_t count() const { return entering + touching + beside; }
};

/** Passes and their figures. */
struct PassResult {
  pcl_spiral::Scan scan;                               ///< of a mesh: its samples, if they were needed
  ScanSide asked_side;                                 ///< what decides the side of the scan
  pcl_spiral::OuterSide side;                          ///< what decided it
  pcl_spiral::SurfaceMesh::ConstPtr mesh;              ///< the part if it is a mesh; null for a scan
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole_scan; ///< with the outliers that were left out
  pcl_spiral::ChosenPart chosen;                       ///< of the scan
  LeftOutLocations left_out;
  pcl_spiral::LocationFigures locations;
  pcl_spiral::BisectionFigures bisection;
  std::vector<pcl_spiral::ToolPoses> passes; ///< in travel order, without locations off the part
  std::size_t off_scan = 0;                  ///< locations left out: no part of the surface below the cutter, and those of left_out
  double length = 0.0;                       ///< of the tip's path along all passes, mm
  std::vector<pcl_spiral::StageCost> stages;
  pcl_spiral::Diagnostics warnings;
  std::optional<pcl_spiral::MachineProgram> program; ///< if a machine is given
  std::vector<pcl_spiral::ToolMoves> moves;          ///< with leads, if an output is CLDATA or has robot frames

  std::size_t poseCount() const
  {
    std::size_t count = 0;
    for (const pcl_spiral::ToolPoses& pass : passes)
      count += pass.size();
    return count;
  }
};
