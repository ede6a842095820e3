// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings of a program that makes passes of a tool.
 */
#pragma once

#include "program/program_job.h"
#include "terminal/part_options.h"
#include "terminal/program_run.h"
#include "terminal/scan_places.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/planning/pass_plan.h>

#include <optional>
#include <string>
#include <vector>

/** Settings that all such programs share: files, tool, machine, run. Lengths in mm, angles in degrees. */
struct PassJob : pcl_spiral::PassSettings, ProgramRun {
  std::string scan; ///< empty if there is none
  std::string part; ///< the file named in messages about the part
  std::vector<std::string> outputs;
  pcl_spiral::ReadOptions read = readFindingOrigin();
  std::optional<Eigen::Vector3d> view_point; ///< of --view-point
  bool flip_scan = false;                    ///< the cutter is on the other side of the scan
  bool leave_out_strays = false;
  PartOptions choice;        ///< which points of the scan are the part
  bool largest_part = false; ///< of several parts, use only the largest
  double thinning = 0.0;     ///< voxel edge; 0: none
  double feed = 1000.0;      ///< mm/min
  ProgramJob program;
};
