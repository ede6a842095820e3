/** \file
 *  From a scan to located passes.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/stage_clock.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/toolpath/location_bisection.h>

#include <optional>
#include <string>
#include <vector>

/** All that a run came to. */
struct Result {
  pcl_spiral::Scan scan; ///< of a mesh the points it was sampled at, where they were needed
  pcl_spiral::SurfaceMesh::ConstPtr mesh; ///< null for a scan
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole_scan; ///< with the strays that were left out
  pcl_spiral::DriveReport drive;
  pcl_spiral::LocationFigures locations;
  pcl_spiral::BisectionFigures bisection;
  std::vector<pcl_spiral::ToolPoses> passes; ///< in travel order, without locations off the scan
  std::size_t off_scan = 0;                  ///< locations left out: no point of the scan below the cutter
  double length = 0.0;                       ///< of the tip's way along all passes, mm
  std::vector<pcl_spiral::StageCost> stages;
  std::vector<std::string> warnings;
  std::optional<pcl_spiral::MachineProgram> program; ///< where a machine is given
};

/** Reads the scan or the mesh, makes the drive path, locates the cutter. \throw UsageError, pcl_spiral::FileError, Cancelled */
Result plan(const Job& job);
