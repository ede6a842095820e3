// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of a program is asked to do that makes passes of a tool.
 */
#pragma once

#include "program/program_job.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/io/cloud_reader.h>

#include <set>
#include <string>
#include <vector>

/** What all such programs are asked for: files, tool, machine, run. Lengths mm, angles degrees. */
struct PassJob {
  std::set<std::string> given; ///< names of the options that were set, here or in a job file
  std::string command;         ///< the call as typed
  std::string scan;            ///< empty where there is none
  std::string part;            ///< the file that messages about the part name
  std::vector<std::string> outputs;
  pcl_spiral::ReadOptions read;
  bool leave_out_strays = false;
  bool largest_part = false; ///< of several, take the largest alone
  double thinning = 0.0;     ///< voxel edge; 0: none
  pcl_spiral::CutterShape cutter;
  std::vector<pcl_spiral::ToolSegment> holder;
  double holder_clearance = 0.0;
  double tolerance = 0.01;     ///< between locations
  double axis_smoothing = 0.0; ///< mm along the path; 0: none
  double max_axis_rate = 0.0;  ///< degrees a mm; 0: no limit
  double feed = 1000.0;        ///< mm/min
  ProgramJob program;
  std::string config_file;
  unsigned int threads = 0;
  bool verbose = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};
