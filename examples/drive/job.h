/** \file
 *  What one run of pcl_spiral_drive is asked to do.
 */
#pragma once

#include "program/program_job.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/mesh/mesh_settings.h>
#include <pcl_spiral/toolpath/drive_settings.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

/** A run as the user described it. Lengths mm, angles degrees. */
struct Job {
  std::set<std::string> given; ///< names of the options that were set, here or in a job file
  std::string command;         ///< the call as typed
  std::string scan;
  std::vector<std::string> outputs;
  pcl_spiral::ReadOptions read;
  bool mesh = false; ///< the scan is a mesh, and its faces count
  pcl_spiral::MeshSettings mesh_settings;
  bool no_gouge_check = false; ///< stand the cutter at the contacts of a mesh without a look at the rest of it
  pcl_spiral::CutterShape cutter;
  std::vector<pcl_spiral::ToolSegment> holder;
  double holder_clearance = 0.0;
  bool leave_out_strays = false;
  bool largest_part = false; ///< of several, drive on the largest alone
  double thinning = 0.0;     ///< voxel edge; 0: none
  pcl_spiral::DriveSettings drive;
  std::string curve_file;
  std::optional<Eigen::Vector3d> column_axis;              ///< direction; found from the scan where none is given
  Eigen::Vector3d column_centre = Eigen::Vector3d::Zero(); ///< a place on it
  std::string config_file;
  double scallop = 0.0;     ///< in place of a step-over
  double tolerance = 0.01;  ///< between locations
  bool one_way = false;
  double axis_smoothing = 0.0; ///< mm along the path; 0: none
  double max_axis_rate = 0.0;  ///< degrees a mm; 0: no limit
  double feed = 1000.0; ///< mm/min
  ProgramJob program;
  unsigned int threads = 0;
  bool verbose = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};
